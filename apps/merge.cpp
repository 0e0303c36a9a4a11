// graze merge: the shares of a diagram, map or comparison, joined to the result of the whole.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <variant>
#include <vector>

#include "graze/base/errors.hpp"
#include "journals.hpp"
#include "run_folder.hpp"
#include "session.hpp"

namespace graze {
namespace {

std::vector<Journal> journals_in(const std::vector<std::string>& folders) {
  std::vector<Journal> journals;
  for (const std::string& folder : folders) {
    std::error_code error;
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
      if (entry.path().extension() == kJournalEnd) files.push_back(entry.path());
    if (error) throw FileError(folder + ": cannot read: " + error.message());
    if (files.empty())
      throw InputError(folder +
                       ": there is no journal in it, as diagram, map or compare with --out leave");
    // In whichever order the folder has them.
    std::sort(files.begin(), files.end());
    for (const auto& file : files) journals.push_back(Journal::open(file));
  }
  return journals;
}

// "3/8, 5/8"
std::string shares_of(const std::vector<std::size_t>& pieces, const JournalHead& head) {
  std::set<std::size_t> parts;
  for (const std::size_t piece : pieces)
    parts.insert(piece / head.block % static_cast<std::size_t>(head.share.of) + 1);
  std::string text;
  for (const std::size_t part : parts)
    text += fmt::format("{}{}/{}", text.empty() ? "" : ", ", part, head.share.of);
  return text;
}

void require_whole(const std::vector<Journal>& journals) {
  const JournalHead& head = journals.front().head();
  std::vector<const Journal*> all;
  for (const Journal& journal : journals) {
    require_same_work(journal.head(), head, journal.file().string());
    all.push_back(&journal);
  }
  const std::vector<std::size_t> missing = missing_pieces(head, all);
  if (!missing.empty())
    throw InputError(
        fmt::format("{} of {} {}s are missing; run --shard {} again with --resume, then merge",
                    missing.size(), head.pieces, head.piece, shares_of(missing, head)));
}

void warn_of_processors(const MergeCommand& command, const std::vector<Journal>& journals) {
  std::set<std::string> processors;
  for (const Journal& journal : journals) processors.insert(journal.head().processor);
  if (processors.size() > 1)
    warn(command, {fmt::format("the shares come from {} kinds of processors; last digits may "
                               "differ from those of a run on one kind",
                               processors.size())});
}

// The command that the shares are of.
Command command_of(const JournalHead& head) {
  std::vector<std::string> words = head.info.arguments;
  words.insert(words.begin(), "graze");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  const ParsedCommand parsed =
      parse_command_line(static_cast<int>(arguments.size()), arguments.data());
  if (!parsed.command) throw InputError("the journals do not tell which command they are of");
  return *parsed.command;
}

// Runs the command of the shares for the whole of its work, of which nothing is left to do.
template <class Sharing>
int run_whole(Sharing whole, const MergeCommand& command, const std::vector<Journal>& journals) {
  JournalHead head = journals.front().head();
  CommonOptions common = command;
  common.name = whole.name;
  common.arguments = words_without(whole.arguments, {"--shard", "--out"});
  static_cast<CommonOptions&>(whole) = common;
  whole.scene_text = head.info.scene_text;
  whole.journal = JournalOptions{};
  whole.journal.goes_on = true;
  whole.journal.arguments = command.arguments;
  const StopSignal stop = stop_signal(command);
  {
    head.share = {};
    Journal joined = Journal::resume(journal_file(command.out, {}), head);
    for (const Journal& journal : journals)
      for (const std::string& name : journal.names())
        if (!joined.has(name) && !stop.requested()) joined.add(name, journal.find(name).value());
  }
  return run(whole);
}

}  // namespace

int run(const MergeCommand& command) {
  const std::vector<Journal> journals = journals_in(command.folders);
  require_whole(journals);
  warn_of_processors(command, journals);
  prepare_output(command);
  return std::visit(
      [&](const auto& shared) -> int {
        if constexpr (requires { shared.journal; }) return run_whole(shared, command, journals);
        throw InputError("the journals are of a command that has no shares");
      },
      command_of(journals.front().head()));
}

}  // namespace graze
