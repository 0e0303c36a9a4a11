// The finished pieces of long work, in a file that only grows: however the program ends, these
// pieces are not done again.
//
// Lines of "CHECKSUM NAME <tab> TEXT", the first of them about the work as a whole. A line that was
// cut off or damaged does not fit its checksum and counts as not written.
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "graze/record/file/journal_head.hpp"
#include "graze/study/compare/comparison_map.hpp"
#include "graze/study/plane/attractor_map.hpp"
#include "graze/study/sweep/run_series.hpp"
#include "graze/study/sweep/settled_row.hpp"
#include "graze/study/sweep/shared_work.hpp"

namespace graze {

// Pieces of long work as one line of text each, which reads back to the last bit.

std::string piece_text(const SweepRow& row);
std::string piece_text(const SettledCell& cell);
std::string piece_text(const ValueRun& run);
std::string piece_text(const ComparedCell& cell);

// Reads the output of `piece_text`. False for any other text.
bool read_piece(const std::string& text, SweepRow& row);
bool read_piece(const std::string& text, SettledCell& cell);
bool read_piece(const std::string& text, ValueRun& run);
bool read_piece(const std::string& text, ComparedCell& cell);

class Journal : public PieceStore {
 public:
  // Whether a journal of unfinished work may be replaced.
  enum class Unfinished { kRefused, kReplaced };
  // Begins a journal in place of an existing one. Throws InputError when that holds finished pieces
  // of unfinished work, unless they may be replaced.
  static Journal begin(const std::filesystem::path& file, const JournalHead& head,
                       Unfinished unfinished = Unfinished::kRefused);
  // Continues the journal, or begins it where there is none. Throws InputError when it belongs to
  // other work than `head`.
  static Journal resume(const std::filesystem::path& file, const JournalHead& head);
  // Reads a journal without adding to it. Throws InputError for other files.
  static Journal open(const std::filesystem::path& file);

  ~Journal() override;
  Journal(Journal&& other) noexcept;
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  const JournalHead& head() const { return head_; }
  const std::filesystem::path& file() const { return file_; }
  // In the order in which they were written.
  const std::vector<std::string>& names() const { return names_; }
  // All of them throw FileError.
  std::optional<std::string> find(const std::string& name) const override;
  bool has(const std::string& name) const override;
  void add(const std::string& name, const std::string& text) override;
  // Marks the work as ended: its result holds all pieces.
  void end();

 private:
  struct Place {
    std::size_t at = 0, size = 0;  // of the text in the file
  };

  Journal(std::filesystem::path file, int descriptor);
  // Opens the file, locked against other runs.
  static Journal writable(const std::filesystem::path& file);
  void start(const JournalHead& head);
  void refuse_unfinished(const JournalHead& head) const;
  void cut_off(std::size_t at);
  void read();
  void take_line(std::string_view line, std::size_t at);
  void note(const std::string& name, Place place);
  void write(const std::string& line);
  [[noreturn]] void fail(const char* what) const;

  std::filesystem::path file_;
  int descriptor_ = -1;
  JournalHead head_;
  bool has_head_ = false, has_ended_ = false;
  std::size_t end_ = 0;  // of the last whole line
  std::vector<std::string> names_;
  std::unordered_map<std::string, Place> places_;
  mutable std::mutex mutex_;
};

// A memory of pieces in a store, which must outlive it; null: remembers nothing. A text that is no
// piece counts as not written.
template <class Piece>
PieceMemory<Piece> memory_in(PieceStore* store) {
  if (!store) return {};
  return {[store](const std::string& name) -> std::optional<Piece> {
            const std::optional<std::string> text = store->find(name);
            Piece piece;
            if (!text || !read_piece(*text, piece)) return {};
            return piece;
          },
          [store](const std::string& name, const Piece& piece) {
            store->add(name, piece_text(piece));
          }};
}

// The pieces of the work, of any share, that none of the journals has.
std::vector<std::size_t> missing_pieces(const JournalHead& head,
                                        const std::vector<const Journal*>& journals);

}  // namespace graze
