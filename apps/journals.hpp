// Long work in pieces that stand in a journal once they are done: a run that goes on with them, and
// the shares of a job array.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "command.hpp"
#include "graze/record/file/journal.hpp"
#include "session.hpp"

namespace graze {

inline constexpr const char* kJournalEnd = ".journal";

// In a folder of results: of all the work, or of a share.
std::filesystem::path journal_file(const std::string& folder, const Share& share);

// Throws InputError where --resume or --shard lack a folder, or a share is to be drawn.
void check_journal_options(const CommonOptions& command, const JournalOptions& options);

// The work of a command in pieces: its journal in the command's folder, where one was asked for,
// and who does it. `head` describes the work; share and processor are filled in.
class JournalledWork {
 public:
  JournalledWork(const CommonOptions& command, const JournalOptions& options,
                 const JournalHead& head);
  JournalledWork(const JournalledWork&) = delete;
  JournalledWork& operator=(const JournalledWork&) = delete;

  // Options of the work that lack how it is done. This must outlive their use.
  template <class Piece>
  void set(SharedWork<Piece>& work) {
    work.threads = command_.threads;
    work.share = options_.share;
    work.memory = memory_in<Piece>(store_);
    work.workers = options_.workers;
  }

  // After the pieces are done: whether all of them are here, to be concluded by the command.
  bool is_whole_here() const;
  // Otherwise: prints what the journal of a share holds, and returns the exit code.
  int conclude_part(StopReason stopped);
  // As graze::conclude. The journal ends with work that was not stopped; the outcome of work that
  // was names the command that goes on.
  template <class Record>
  int conclude(Record& record, StopReason stopped, const Scene& scene) {
    tell_how_to_go_on(stopped, outcome_of(record));
    const int code = graze::conclude(command_, record, scene);
    end(stopped);
    return code;
  }

 private:
  void tell_how_to_go_on(StopReason stopped, Outcome& outcome) const;
  void end(StopReason stopped);

  const CommonOptions& command_;
  const JournalOptions& options_;
  std::optional<Journal> journal_;
  PieceStore* store_;
};

}  // namespace graze
