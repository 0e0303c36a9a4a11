#include <fmt/format.h>
#include <fmt/ranges.h>

#include "completion.hpp"

namespace graze {
namespace {

constexpr const char* kFishFunctions =
    R"sh(# Completion of graze for fish, made from the program's own options.

# The parameters of the scene on the line, each with this behind it.
function __graze_parameters
    for word in (commandline -opc)
        if string match -q '*.toml' -- $word; and test -f $word
            graze check $word --parameters --quiet 2>/dev/null | string replace -r ' .*' "$argv[1]"
            return
        end
    end
end

complete -c graze -f
complete -c graze -n __fish_use_subcommand -s h -l help -d 'Print the help'
complete -c graze -n __fish_use_subcommand -l version -d 'Print the version'
)sh";

std::string fish_quoted(const std::string& text) {
  std::string made;
  for (const char c : text) {
    if (c == '\'' || c == '\\') made += '\\';
    made += c;
  }
  return "'" + made + "'";
}

// What a value may be, as arguments of `complete`.
std::string values(const OptionDescription& option, const std::string& commands) {
  switch (value_kind(option)) {
    case ValueKind::kChoice:
      return fmt::format(" -a '{}'", fmt::join(option.choices, " "));
    case ValueKind::kCommand:
      return fmt::format(" -a '{}'", commands);
    case ValueKind::kFile:
      return " -F";
    case ValueKind::kScene:
      return " -k -a '(__fish_complete_suffix .toml)'";
    case ValueKind::kFolder:
      return " -a '(__fish_complete_directories)'";
    case ValueKind::kParameter:
      return " -a '(__graze_parameters)'";
    case ValueKind::kSetting:
      return " -a '(__graze_parameters =)'";
    case ValueKind::kAny:
      break;
  }
  return "";
}

}  // namespace

std::string fish_completion(const Commands& commands) {
  std::vector<std::string> names;
  for (const auto& command : commands) names.push_back(command.name);
  const std::string all = fmt::format("{}", fmt::join(names, " "));
  std::string text = kFishFunctions;
  for (const auto& command : commands)
    text += fmt::format("complete -c graze -n __fish_use_subcommand -a {} -d {}\n", command.name,
                        fish_quoted(in_brief(command.what)));
  for (const auto& command : commands) {
    const std::string of =
        fmt::format("complete -c graze -n '__fish_seen_subcommand_from {}'", command.name);
    text += of + " -s h -l help -d 'Print the help'\n";
    for (const auto& file : command.files) text += of + values(file, all) + "\n";
    for (const auto& option : command.options)
      text += fmt::format("{}{} -l {}{} -d {}\n", of,
                          option.short_name.empty() ? "" : " -s " + option.short_name, option.name,
                          option.is_flag()                         ? ""
                          : value_kind(option) == ValueKind::kFile ? " -r" + values(option, all)
                                                                   : " -x" + values(option, all),
                          fish_quoted(in_brief(option.what)));
  }
  return text;
}

}  // namespace graze
