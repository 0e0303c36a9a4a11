#include <fmt/format.h>
#include <fmt/ranges.h>

#include "completion.hpp"

namespace graze {
namespace {

constexpr const char* kBashFunctions =
    R"sh(# Completion of graze for bash, made from the program's own options.

# The parameters of the scene on the line, each with this behind it.
_graze_parameters() {
  local word name rest
  for word in "${COMP_WORDS[@]:2}"; do
    [[ $word == *.toml && -f $word ]] || continue
    "${COMP_WORDS[0]}" check "$word" --parameters --quiet 2> /dev/null |
      while read -r name rest; do printf '%s%s\n' "$name" "$1"; done
    return
  done
}

_graze_words() { mapfile -t COMPREPLY < <(compgen -W "$1" -- "$2"); }

# What a value may be: any, choice WORDS.., scene, file, folder, parameter, setting.
_graze_value() {
  local current=$1 kind=$2
  shift 2
  case $kind in
    choice)
      local words=$*
      _graze_words "${words% FILES}" "$current"
      if [[ $words == *" FILES" && ${#COMPREPLY[@]} -eq 0 ]]; then _graze_value "$current" file; fi
      ;;
    parameter) _graze_words "$(_graze_parameters)" "$current" ;;
    setting)
      compopt -o nospace
      _graze_words "$(_graze_parameters =)" "$current"
      ;;
    scene)
      compopt -o filenames
      mapfile -t COMPREPLY < <(compgen -f -X '!*.toml' -- "$current"; compgen -d -- "$current")
      ;;
    file) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;
    folder) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- "$current") ;;
  esac
}

)sh";

std::string value(const OptionDescription& option, const std::string& commands) {
  switch (value_kind(option)) {
    case ValueKind::kChoice:
      return fmt::format("choice {}", fmt::join(option.choices, " "));
    case ValueKind::kCommand:
      return "choice " + commands;
    case ValueKind::kFile:
      return "file";
    case ValueKind::kScene:
      return "scene";
    case ValueKind::kFolder:
      return "folder";
    case ValueKind::kParameter:
      return "parameter";
    case ValueKind::kSetting:
      return "setting";
    case ValueKind::kAny:
      break;
  }
  return "any";
}

// Which of several files a word is, the shell does not know: options and their values stand
// between.
std::string file_value(const CommandDescription& command, const std::string& commands) {
  const std::string first = value(command.files.front(), commands);
  if (command.files.size() == 1) return first;
  return value_kind(command.files.front()) == ValueKind::kChoice ? first + " FILES" : "file";
}

std::string with_dashes(const OptionDescription& option) {
  return (option.short_name.empty() ? "" : "-" + option.short_name + " ") + "--" + option.name;
}

}  // namespace

std::string bash_completion(const Commands& commands) {
  std::vector<std::string> names;
  for (const auto& command : commands) names.push_back(command.name);
  const std::string all = fmt::format("{}", fmt::join(names, " "));
  std::string values, options, files;
  for (const auto& command : commands) {
    std::vector<std::string> words{"-h --help"};
    for (const auto& option : command.options) {
      words.push_back(with_dashes(option));
      if (option.is_flag()) continue;
      const std::string pattern = option.short_name.empty()
                                      ? ""
                                      : fmt::format("{}:-{} | ", command.name, option.short_name);
      values += fmt::format("    {}{}:--{}) _graze_value \"$current\" {}; return ;;\n", pattern,
                            command.name, option.name, value(option, all));
    }
    options += fmt::format("    {}) options=\"{}\" ;;\n", command.name, fmt::join(words, " "));
    if (!command.files.empty())
      files += fmt::format("    {}) _graze_value \"$current\" {} ;;\n", command.name,
                           file_value(command, all));
  }
  std::string text = kBashFunctions;
  text += R"sh(_graze() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]}
  local options=
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
)sh";
  text += fmt::format("    _graze_words \"{} --help --version\" \"$current\"\n", all);
  text += R"sh(    return
  fi
  # bash takes --option=value for three words.
  if [[ $previous == = ]]; then previous=${COMP_WORDS[COMP_CWORD-2]}; fi
  if [[ $current == = ]]; then current=; fi
  case $command:$previous in
)sh" + values +
          R"sh(  esac
  case $command in
)sh" + options +
          R"sh(  esac
  if [[ $current == -* ]]; then
    _graze_words "$options" "$current"
    return
  fi
  case $command in
)sh" + files +
          R"sh(  esac
}
complete -F _graze graze
)sh";
  return text;
}

}  // namespace graze
