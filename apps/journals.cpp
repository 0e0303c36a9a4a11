#include "journals.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "graze/base/errors.hpp"
#include "graze/record/share_record.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/shell_word.hpp"
#include "graze/report/text/text.hpp"
#include "session.hpp"

namespace graze {

std::filesystem::path journal_file(const std::string& folder, const Share& share) {
  const std::string name =
      share.is_all() ? "rows" : fmt::format("rows-{}-of-{}", share.part, share.of);
  return std::filesystem::path(folder) / (name + kJournalEnd);
}

void read_share(const std::string& text, Share& share) {
  int end = 0;
  const bool read = std::sscanf(text.c_str(), "%9d/%9d%n", &share.part, &share.of, &end) == 2 &&
                    end == static_cast<int>(text.size());
  if (!read || share.part < 1 || share.of < share.part)
    throw InputError(fmt::format(
        "--shard: '{}' is not allowed; give the share's number and how many there are, like 3/8",
        text));
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

namespace {

// The journal in use; nullopt when no folder was asked for.
std::optional<Journal> journal_of(const CommonOptions& command, const JournalOptions& options,
                                  JournalHead head) {
  if (command.out.empty()) return {};
  head.share = options.share;
  head.processor = processor_name();
  const std::filesystem::path file = journal_file(command.out, options.share);
  if (!options.goes_on)
    return Journal::begin(
        file, head,
        options.restarts ? Journal::Unfinished::kReplaced : Journal::Unfinished::kRefused);
  Journal journal = Journal::resume(file, head);
  if (journal.head().processor != head.processor)
    warn(command, {fmt::format("{}: it was begun on another kind of processor ({}; here {}); last "
                               "digits may differ from those of a run on one kind",
                               file.string(), journal.head().processor, head.processor)});
  return journal;
}

}  // namespace

JournalledWork::JournalledWork(const CommonOptions& command, const JournalOptions& options,
                               const JournalHead& head)
    : command_(command),
      options_(options),
      journal_(journal_of(command, options, head)),
      // Whoever does some of the work knows nothing of shares.
      store_(options.workers->begin(head_text(head), processor_name(),
                                    journal_ ? &*journal_ : nullptr)) {}

bool JournalledWork::is_whole_here() const {
  return options_.share.is_all() && !options_.workers->serves_another();
}

void JournalledWork::tell_how_to_go_on(StopReason stopped, Outcome& outcome) const {
  if (stopped == StopReason::kNone || !journal_) return;
  std::vector<std::string> words =
      options_.arguments.empty() ? command_.arguments : options_.arguments;
  std::erase(words, "--restart-work");
  if (!options_.goes_on) words.emplace_back("--resume");
  outcome.message += command_.caller ? "; the same call with 'resume' goes on"
                                     : "; to go on: " + shell_command(words, options_.program);
}

void JournalledWork::end(StopReason stopped) {
  if (journal_ && stopped == StopReason::kNone) journal_->end();
}

int JournalledWork::conclude_part(StopReason stopped) {
  if (options_.workers->serves_another()) return 0;
  ShareRecord record = share_record(*journal_, stopped);
  if (record.kept == record.due) stopped = StopReason::kNone;
  tell_how_to_go_on(stopped, record.outcome);
  end(stopped);
  // Its tables are those of the whole, which the journals make.
  CommonOptions printed = command_;
  printed.out.clear();
  return graze::conclude(printed, record.info, record.outcome, {json_of(record), text_of(record)});
}

}  // namespace graze
