#include <fmt/format.h>
#include <fmt/ranges.h>

#include "completion.hpp"

namespace graze {
namespace {

constexpr const char* kZshFunctions = R"sh(#compdef graze
# Completion of graze for zsh, made from the program's own options.

# The parameters of the scene on the line, with what stands behind a name.
_graze_parameters() {
  local word
  local -a names
  for word in $words; do
    [[ $word == *.toml && -f $word ]] || continue
    names=(${${(f)"$(graze check $word --parameters --quiet 2> /dev/null)"}%% *})
    compadd "$@" -a names
    return
  done
}
_graze_settings() { _graze_parameters -S = }

)sh";

std::string zsh_quoted(const std::string& text) {
  std::string made;
  for (const char c : text) {
    if (c == '\'') made += "'\\'";
    if (c == '[' || c == ']' || c == ':' || c == '\\') made += '\\';
    made += c;
  }
  return made;
}

std::string action(const OptionDescription& option) {
  switch (value_kind(option)) {
    case ValueKind::kChoice:
      return fmt::format("({})", fmt::join(option.choices, " "));
    case ValueKind::kCommand:
      return "_graze_commands";
    case ValueKind::kFile:
      return "_files";
    case ValueKind::kScene:
      return "_files -g \"*.toml\"";
    case ValueKind::kFolder:
      return "_files -/";
    case ValueKind::kParameter:
      return "_graze_parameters";
    case ValueKind::kSetting:
      return "_graze_settings";
    case ValueKind::kAny:
      break;
  }
  return " ";
}

// A specification of _arguments for each name of an option.
std::string specifications(const OptionDescription& option) {
  const std::string what = zsh_quoted(in_brief(option.what));
  const std::string value =
      option.is_flag()
          ? ""
          : fmt::format(":{}:{}",
                        zsh_quoted(option.placeholder.empty() ? option.name : option.placeholder),
                        action(option));
  const std::string twice = option.takes_several ? "*"
                            : option.short_name.empty()
                                ? ""
                                : fmt::format("(-{} --{})", option.short_name, option.name);
  std::string text = fmt::format(" \\\n        '{}--{}{}[{}]{}'", twice, option.name,
                                 option.is_flag() ? "" : "=", what, value);
  if (!option.short_name.empty())
    text += fmt::format(" \\\n        '{}-{}{}[{}]{}'", twice, option.short_name,
                        option.is_flag() ? "" : "+", what, value);
  return text;
}

}  // namespace

std::string zsh_completion(const Commands& commands) {
  std::string list, cases;
  for (const auto& command : commands) {
    list += fmt::format("    '{}:{}'\n", command.name, zsh_quoted(in_brief(command.what)));
    cases +=
        fmt::format("    {})\n      _arguments -s -S '(-h --help)'{{-h,--help}}'[Print the help]'",
                    command.name);
    for (const auto& option : command.options) cases += specifications(option);
    for (const auto& file : command.files)
      cases += fmt::format(" \\\n        '{}:{}:{}'", file.takes_several ? "*" : "",
                           zsh_quoted(file.name), action(file));
    cases += "\n      ;;\n";
  }
  return std::string(kZshFunctions) + "_graze_commands() {\n  local -a commands=(\n" + list +
         R"sh(  )
  _describe command commands
}

_graze() {
  if ((CURRENT == 2)); then
    _graze_commands
    return
  fi
  local command=$words[2]
  shift words
  ((CURRENT--))
  case $command in
)sh" + cases +
         R"sh(  esac
}
_graze "$@"
)sh";
}

}  // namespace graze
