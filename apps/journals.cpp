#include "journals.hpp"

#include <fmt/format.h>

#include "graze/base/errors.hpp"
#include "graze/record/detail/share_record.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/text.hpp"
#include "session.hpp"

namespace graze {

std::filesystem::path journal_file(const std::string& folder, const Share& share) {
  const std::string name =
      share.is_all() ? "rows" : fmt::format("rows-{}-of-{}", share.part, share.of);
  return std::filesystem::path(folder) / (name + kJournalEnd);
}

void check_journal_options(const CommonOptions& command, const JournalOptions& options) {
  if (options.goes_on && command.out.empty())
    throw InputError("--resume: give the folder to go on in with --out");
  if (options.share.is_all()) return;
  if (command.out.empty())
    throw InputError("--shard: give the folder for what the share finds with --out");
  if (!command.plot.empty())
    throw InputError("--plot: a share is not drawn; give it to graze merge");
}

std::optional<Journal> journal_of(const CommonOptions& command, const JournalOptions& options,
                                  JournalHead head) {
  if (command.out.empty()) return {};
  head.share = options.share;
  head.processor = processor_name();
  const std::filesystem::path file = journal_file(command.out, options.share);
  if (!options.goes_on) return Journal::begin(file, head);
  Journal journal = Journal::resume(file, head);
  if (journal.head().processor != head.processor)
    warn(command, {fmt::format("{}: it was begun on another kind of processor ({}; here {}); last "
                               "digits may differ from those of a run on one kind",
                               file.string(), journal.head().processor, head.processor)});
  return journal;
}

int conclude_share(const CommonOptions& command, const Journal& journal, StopReason stopped) {
  const ShareRecord record = share_record(journal, stopped);
  // Its tables are those of the whole, which the journals make.
  CommonOptions printed = command;
  printed.out.clear();
  return conclude(printed, record.info, record.outcome, {json_of(record), text_of(record)});
}

}  // namespace graze
