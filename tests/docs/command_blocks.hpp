// The commands of a page, and what the page says that they print.
//
// - An indented block with a line that begins with "$ " is a dialogue: each such line (with those
//   that a backslash at its end joins to it) is a command, and the lines below are what it prints.
// - An indented block with a line that begins with "build/" and none with "$ " is a script, run as
//   a whole; the page shows nothing of what it prints.
// - An indented block below the line `<!-- printed -->` is a part of what the last command printed.
// - `<!-- prints 20.31 13.593e-3 5..7 -->` holds numbers that the last command printed, rounded;
//   the digits before an "e" stand in the page's text. A range "a..b" holds one of them. Numbers
//   after a label, `impacts:834` or `stuck_time:0..1`, stand in a line that begins with it.
// - A command within a comment is run like others: for numbers of tables and prose.
// - A scene that a command names and that is not there is the block before it that is no command.
#pragma once

#include <string>
#include <vector>

namespace graze::support {

struct PageCommand {
  int line = 0;                     // of the page, from 1
  std::string text;                 // as given to the shell
  bool shows = false;               // whether the page shows its output
  std::vector<std::string> output;  // the lines shown below it
  // Further parts of the output, and numbers that stand in it.
  std::vector<std::vector<std::string>> parts;
  std::vector<std::string> numbers;
  std::string data;  // the last block before it that is no command
};

std::vector<PageCommand> commands_of(const std::string& page);

// The page without its comments: what a reader sees.
std::string visible_text(const std::string& page);

}  // namespace graze::support
