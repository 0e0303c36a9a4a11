#include "usage_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "graze/scene/detail/suggestion.hpp"

namespace graze {

std::string unknown_option(const CLI::App& app) {
  if (app.get_subcommands().empty()) return "";
  const CLI::App& command = *app.get_subcommands().front();
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) names.push_back(option->get_name());
  for (const std::string& word : command.remaining()) {
    if (word.rfind('-', 0) != 0) continue;
    const std::string close = closest_name(word, names);
    return fmt::format("'{}' is no option of {}{}", word, command.get_name(),
                       close.empty() ? "" : fmt::format("; did you mean '{}'?", close));
  }
  return "";
}

std::string empty_option(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::vector<std::string>& values = option->results();
    if (option->get_name() != "--set" && option->get_expected_max() > 0 &&
        std::find(values.begin(), values.end(), "") != values.end())
      return fmt::format("{}: the value is empty", option->get_name());
  }
  return "";
}

std::string unknown_command(int argc, char** argv, const CLI::App& app) {
  if (argc < 2)
    return "give a command: check, simulate, orbit, continue, diagram, map, merge, view, cost, fit "
           "or compare";
  const std::string word = argv[1];
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), word) != names.end()) return "";
  if (word.rfind('-', 0) == 0) return fmt::format("'{}': options come after the command", word);
  const std::string close = closest_name(word, names);
  return close.empty() ? fmt::format("'{}' is no command", word)
                       : fmt::format("'{}' is no command; did you mean '{}'?", word, close);
}

}  // namespace graze
