#include "command_reference.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

namespace graze {
namespace {

// A cell of a table: bars would end it.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

std::string as_given(const OptionDescription& option) {
  const std::string brief =
      option.short_name.empty() ? "" : fmt::format("`-{}`, ", option.short_name);
  return fmt::format("{}`{}`", brief, cell(option.as_given()));
}

// The commands that have an option in these words, by its row.
using Rows = std::map<std::string, std::vector<std::string>>;

std::string row(const OptionDescription& option) {
  return fmt::format("|{}|{}|", as_given(option), cell(option.help));
}

std::string section(const CommandDescription& command, const Rows& rows) {
  std::string files, own;
  for (const OptionDescription& file : command.files) {
    const std::string name = file.name + (file.takes_several ? " .." : "");
    files += file.is_required ? " " + name : " [" + name + "]";
  }
  std::vector<std::string> shared;
  for (const OptionDescription& option : command.options) {
    if (rows.at(row(option)).size() > 1)
      shared.push_back(fmt::format("`--{}`", option.name));
    else
      own += row(option) + "\n";
  }
  std::string text = fmt::format("\n## {0}\n\n{1}: `graze {0}{2}{3}`.\n", command.name,
                                 command.what, files, command.options.empty() ? "" : " [OPTIONS]");
  if (!own.empty()) text += "\n|option|meaning|\n|---|---|\n" + own;
  if (!shared.empty())
    text += fmt::format("\n[Shared](#options-that-commands-share) with other commands: {}.\n",
                        fmt::join(shared, ", "));
  return text;
}

}  // namespace

std::string command_reference(const std::vector<CommandDescription>& commands) {
  Rows rows;
  std::vector<std::string> order;
  for (const CommandDescription& command : commands)
    for (const OptionDescription& option : command.options) {
      std::vector<std::string>& users = rows[row(option)];
      if (users.empty()) order.push_back(row(option));
      users.push_back(command.name);
    }
  std::string text =
      "# Commands and their options\n\n"
      "`graze COMMAND --help` prints the same of one command. Options that several commands have "
      "in\n"
      "the same words stand once, at [the end](#options-that-commands-share). What scenes hold, "
      "and what\n"
      "commands print and write, is in [scenes.md](scenes.md) and [results.md](results.md).\n";
  for (const CommandDescription& command : commands) text += section(command, rows);
  text += "\n## Options that commands share\n\n|option|meaning|of|\n|---|---|---|\n";
  for (const std::string& shared : order)
    if (const auto& users = rows[shared]; users.size() > 1)
      text += fmt::format(
          "{}{}|\n", shared,
          users.size() == commands.size() ? "all" : fmt::to_string(fmt::join(users, ", ")));
  return text;
}

}  // namespace graze
