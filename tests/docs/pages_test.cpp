// What README and docs show is what the program prints. What cannot be run here, or takes too long,
// stands in exceptions.txt with its reason; `bash tests/docs/long.sh` runs what takes long.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "apps/program.hpp"
#include "docs/command_blocks.hpp"
#include "docs/shown_output.hpp"

namespace graze::support {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = GRAZE_SOURCE_DIR;

struct Exception {
  std::string kind, page, command, reason;
};

// The lines of exceptions.txt; it says itself what its columns are.
const std::vector<Exception>& exceptions() {
  static const std::vector<Exception> list = [] {
    std::vector<Exception> rows;
    for (const std::string& line : lines_of(kRoot / "tests/docs/exceptions.txt")) {
      if (line.empty() || line[0] == '#') continue;
      std::vector<std::string> cells;
      std::istringstream stream(line);
      for (std::string cell; std::getline(stream, cell, '|');)
        cells.push_back(std::regex_replace(cell, std::regex("^ +| +$"), ""));
      if (cells.size() == 4)
        rows.push_back({cells[0], cells[1], cells[2], cells[3]});
      else
        ADD_FAILURE() << "exceptions.txt has a line of another form: " << line;
    }
    return rows;
  }();
  return list;
}

// The command in one line of single blanks.
std::string one_line(const std::string& command) {
  std::string text = std::regex_replace(command, std::regex("\\\\?\n"), " ");
  text = std::regex_replace(text, std::regex(" +"), " ");
  return std::regex_replace(text, std::regex("^ | $"), "");
}

const Exception* exception_of(const std::string& page, const PageCommand& command) {
  const std::string text = one_line(command.text);
  for (const Exception& exception : exceptions())
    if ((exception.page == page || exception.page == "*") &&
        text.find(exception.command) != std::string::npos)
      return &exception;
  return nullptr;
}

std::vector<std::string> pages() {
  std::vector<std::string> list{"README.md"};
  for (const fs::directory_entry& entry : fs::directory_iterator(kRoot / "docs"))
    if (entry.path().extension() == ".md")
      list.push_back("docs/" + entry.path().filename().string());
  std::sort(list.begin(), list.end());
  return list;
}

// A command of which a page shows nothing draws the same picture on every page: its file's name
// does not tell it apart.
std::string work_of(const PageCommand& command) {
  return std::regex_replace(one_line(command.text), std::regex(" --plot [\\w./]+"), "");
}

bool is_shown(const PageCommand& command) {
  return command.shows || !command.parts.empty() || !command.numbers.empty();
}

// Whether the command shows nothing here and is run for an earlier page, or with its output.
bool is_run_elsewhere(const std::string& page, const PageCommand& command) {
  static const std::map<std::string, std::string> places = [] {
    std::map<std::string, std::string> first;
    for (const bool shown : {true, false})
      for (const std::string& name : pages())
        for (const PageCommand& each : commands_of(read_text(kRoot / name)))
          if (is_shown(each) == shown) first.emplace(work_of(each), name);
    return first;
  }();
  return !is_shown(command) && places.at(work_of(command)) != page;
}

// A folder that looks like the project's root to the commands of a page.
void furnish(const ScratchFolder& folder) {
  fs::create_directories(folder / "build");
  fs::create_symlink(GRAZE_PROGRAM, folder / "build/graze");
  fs::create_symlink(GRAZE_EXAMPLES, folder / "build/tests");
  fs::create_symlink(kRoot / "data", folder / "data");
  fs::create_directories(folder / "docs/pictures");
}

// Scenes that the page tells the reader to write.
void write_missing_scene(const ScratchFolder& folder, const PageCommand& command) {
  std::smatch match;
  if (std::regex_search(command.text, match, std::regex(" (\\w+\\.toml)")) &&
      !fs::exists(folder / match[1].str()))
    std::ofstream(folder / match[1].str()) << command.data;
}

// Processor time of all that was run so far, s.
double child_seconds() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

struct Printed {
  std::vector<std::string> out, all;  // without and with its warnings, which come first
  int code = 0;
};

Printed run(const ScratchFolder& folder, const PageCommand& command, const std::string& limit) {
  std::ofstream(folder / "command.sh") << command.text;
  const std::string line = "cd '" + folder.string() + "' && timeout " + limit +
                           " bash command.sh > printed.txt 2> warnings.txt < /dev/null";
  const double before = child_seconds();
  const int status = std::system(line.c_str());
  std::printf("%6.2f s  %s\n", child_seconds() - before, one_line(command.text).c_str());
  Printed printed{lines_of(folder / "printed.txt"), lines_of(folder / "warnings.txt"),
                  WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status)};
  printed.all.insert(printed.all.end(), printed.out.begin(), printed.out.end());
  return printed;
}

std::vector<std::string> without_numbers(std::vector<std::string> lines) {
  for (std::string& line : lines)
    for (const std::string& number : numbers_in(line))
      line.replace(line.find(number), number.size(), "#");
  return lines;
}

// Whether a number that is printed is the one given, or lies in the range given; after a label and
// a colon, in a line that begins with it.
bool is_printed(const std::string& wanted, const std::vector<std::string>& printed) {
  const std::size_t colon = wanted.find(':');
  const std::string given = colon == std::string::npos ? wanted : wanted.substr(colon + 1);
  const std::string label = colon == std::string::npos
                                ? ""
                                : std::regex_replace(wanted.substr(0, colon), std::regex("_"), " ");
  const std::size_t dots = given.find("..");
  for (const std::string& line : printed)
    for (const std::string& number : numbers_in(line)) {
      if (line.find(label) != line.find_first_not_of(' ') && !label.empty()) continue;
      const double value = std::stod(number);
      if (dots == std::string::npos
              ? is_rounding(given, number)
              : value >= std::stod(given) && value <= std::stod(given.substr(dots + 2)))
        return true;
    }
  return false;
}

void expect_shown(const PageCommand& command, bool varies, const Printed& printed) {
  const auto adapted = [&](const std::vector<std::string>& lines) {
    return varies ? without_numbers(lines) : lines;
  };
  const std::vector<std::string> shown = adapted(command.output), all = adapted(printed.all);
  // Warnings may be left out.
  if (command.shows && !difference(shown, adapted(printed.out), true).empty()) {
    EXPECT_EQ(difference(shown, all, true), "");
  }
  for (const std::vector<std::string>& part : command.parts)
    EXPECT_EQ(difference(adapted(part), all, false), "");
  for (const std::string& number : command.numbers)
    EXPECT_TRUE(is_printed(number, printed.all)) << "nothing printed rounds to " << number;
}

// The digits of a number that a reader sees: 13.593 of 13.593e-3, both ends of a range.
void expect_visible(const PageCommand& command, const std::string& text) {
  for (const std::string& given : command.numbers)
    for (const std::string& number :
         numbers_in(std::regex_replace(given, std::regex("^.*:|\\.\\."), " ")))
      EXPECT_NE(text.find(number.substr(0, number.find_first_of("eE"))), std::string::npos)
          << number << " does not stand in the text";
}

class Pages : public testing::TestWithParam<std::string> {};

TEST_P(Pages, ShowWhatIsPrinted) {
  const bool takes_long = std::getenv("GRAZE_LONG_BLOCKS") != nullptr;
  const std::string page = read_text(kRoot / GetParam()), text = visible_text(page);
  const ScratchFolder folder;
  furnish(folder);
  for (const PageCommand& command : commands_of(page)) {
    SCOPED_TRACE(GetParam() + ":" + std::to_string(command.line) + ": " + one_line(command.text));
    expect_visible(command, text);
    const Exception* exception = exception_of(GetParam(), command);
    const std::string kind = exception ? exception->kind : "";
    if (kind == "never" || (kind == "long") != takes_long) continue;
    if (is_run_elsewhere(GetParam(), command)) continue;
    write_missing_scene(folder, command);
    // Ten times what a block may take: against hanging.
    const Printed printed = run(folder, command, takes_long ? "6000" : "100");
    if (!is_shown(command)) {
      EXPECT_TRUE(printed.code == 0 || printed.code == 3) << "exit code " << printed.code;
    }
    expect_shown(command, kind == "varies", printed);
  }
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  return fs::path(info.param).stem().string();
}

INSTANTIATE_TEST_SUITE_P(Documentation, Pages, testing::ValuesIn(pages()), test_name);

// An exception that fits no command any more would hide the next one that it fits.
TEST(Exceptions, FitCommands) {
  std::set<const Exception*> used;
  for (const std::string& name : pages())
    for (const PageCommand& command : commands_of(read_text(kRoot / name)))
      used.insert(exception_of(name, command));
  const std::set<std::string> kinds{"long", "never", "varies"};
  for (const Exception& exception : exceptions()) {
    EXPECT_TRUE(used.count(&exception)) << exception.page << ": " << exception.command;
    EXPECT_TRUE(kinds.count(exception.kind)) << exception.kind;
    EXPECT_FALSE(exception.reason.empty()) << exception.command;
  }
}

// A reader who is to wait is told how long: the page has the time that exceptions.txt gives, as
// "about 45 s", where it is ten seconds or more.
TEST(Exceptions, TellTheirTimes) {
  for (const Exception& exception : exceptions()) {
    std::smatch time;
    if (exception.kind != "long" ||
        !std::regex_search(exception.reason, time, std::regex("\\b(\\d\\d+ s|\\d+ minutes)\\b")))
      continue;
    EXPECT_NE(visible_text(read_text(kRoot / exception.page)).find("about " + time[1].str()),
              std::string::npos)
        << exception.page << ": " << exception.command << " takes " << time[1];
  }
}

}  // namespace
}  // namespace graze::support
