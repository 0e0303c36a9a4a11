// Long work in pieces that stand in a journal once they are done: a run that goes on with them, and
// the shares of a job array.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "command.hpp"
#include "graze/record/file/detail/journal.hpp"

namespace graze {

inline constexpr const char* kJournalEnd = ".journal";

// In a folder of results: of all the work, or of a share.
std::filesystem::path journal_file(const std::string& folder, const Share& share);

// Throws InputError where --resume or --shard lack a folder, or a share is to be drawn.
void check_journal_options(const CommonOptions& command, const JournalOptions& options);

// The journal of the command's folder, which stands; nothing where no folder was asked for. `head`
// tells of the work; share and processor are filled in.
std::optional<Journal> journal_of(const CommonOptions& command, const JournalOptions& options,
                                  JournalHead head);

// Prints what the journal of a share holds; returns the exit code.
int conclude_share(const CommonOptions& command, const Journal& journal, StopReason stopped);

}  // namespace graze
