#include "journals.hpp"

#include <fmt/format.h>

#include "graze/base/errors.hpp"
#include "graze/record/detail/share_record.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/text.hpp"
#include "session.hpp"

namespace graze {

std::filesystem::path journal_file(const Command& command) {
  const std::string name = command.share.is_all()
                               ? "rows"
                               : fmt::format("rows-{}-of-{}", command.share.part, command.share.of);
  return std::filesystem::path(command.out) / (name + kJournalEnd);
}

void check_journal_options(const Command& command) {
  if (command.goes_on && command.out.empty())
    throw InputError("--resume: give the folder to go on in with --out");
  if (command.share.is_all()) return;
  if (command.out.empty())
    throw InputError("--shard: give the folder for what the share finds with --out");
  if (!command.plot.empty())
    throw InputError("--plot: a share is not drawn; give it to graze merge");
}

std::optional<Journal> journal_of(const Command& command, JournalHead head) {
  if (command.out.empty()) return {};
  head.share = command.share;
  head.processor = processor_name();
  const std::filesystem::path file = journal_file(command);
  if (!command.goes_on) return Journal::begin(file, head);
  Journal journal = Journal::resume(file, head);
  if (journal.head().processor != head.processor)
    warn(command, {fmt::format("{}: it was begun on another kind of processor ({}; here {}); last "
                               "digits may differ from those of a run on one kind",
                               file.string(), journal.head().processor, head.processor)});
  return journal;
}

int conclude_share(const Command& command, const Journal& journal, StopReason stopped) {
  const ShareRecord record = share_record(journal, stopped);
  // Its tables are those of the whole, which the journals make.
  Command printed = command;
  printed.out.clear();
  return conclude(printed, record.info, record.outcome,
                  {json_of(record), text_of(record), {}, {}, {}});
}

}  // namespace graze
