#include "usage_errors.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "graze/scene/suggestion.hpp"

namespace graze {
namespace {

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

// The first word is no command.
std::string unknown_command(const std::vector<std::string>& words, const CLI::App& app) {
  const std::vector<std::string> names = commands_of(app);
  if (words.empty()) return fmt::format("give a command: {}", joined(names, "or"));
  const std::string& word = words.front();
  if (std::find(names.begin(), names.end(), word) != names.end()) return "";
  if (word.rfind('-', 0) == 0) return fmt::format("'{}': options come after the command", word);
  return no_command(word, app);
}

std::string unknown_option(const CLI::App& command) {
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

// Words that belong to no option, beyond the files that the command takes.
std::string needless_words(const CommandDescription& command, const CLI::App& given) {
  std::vector<std::string> files, words;
  bool has_setting = false;
  for (const OptionDescription& file : command.files) files.push_back(file.name);
  for (const std::string& word : given.remaining()) {
    words.push_back(fmt::format("'{}'", word));
    has_setting = has_setting || word.find('=') != std::string::npos;
  }
  // The parser has them from the last to the first.
  std::reverse(words.begin(), words.end());
  return fmt::format("{} takes {}; {} {} too many{}", command.name,
                     files.empty() ? "no words but options" : joined(files, "and"),
                     joined(words, "and"), words.size() == 1 ? "is" : "are",
                     has_setting ? ", each setting has a --set of its own" : "");
}

std::string missing_options(const CommandDescription& command, const CLI::App& given) {
  std::vector<std::string> names;
  for (const OptionDescription& file : command.files)
    if (file.is_required && given.count(file.name) == 0) names.push_back(file.name);
  for (const OptionDescription& option : command.options)
    if (option.is_required && given.count("--" + option.name) == 0)
      names.push_back(option.as_given());
  return names.empty()
             ? ""
             : fmt::format("{} {} missing", joined(names, "and"), names.size() == 1 ? "is" : "are");
}

// An option that was given more often than it takes values; else the last word, which has none.
std::string wrong_number_of_values(const CommandDescription& command, const CLI::App& given,
                                   const std::string& last_word) {
  for (const OptionDescription& option : command.options) {
    const std::size_t times = given.count("--" + option.name);
    if (times > 1 && !option.takes_several && !option.is_flag())
      return fmt::format("--{} was given {}; it takes one value", option.name,
                         times == 2 ? "twice" : fmt::format("{} times", times));
  }
  const std::string last = last_word.substr(0, last_word.find('='));
  for (const OptionDescription& option : command.options) {
    const bool is_short = !option.short_name.empty() && last.rfind("--", 0) != 0 &&
                          last.rfind('-', 0) == 0 && last.back() == option.short_name.front();
    if (last == "--" + option.name || is_short)
      return fmt::format("--{}: the value is missing; give {}", option.name, option.as_given());
  }
  return "";
}

bool reads_as_truth(const std::string& word) {
  bool truth = false;
  return CLI::detail::lexical_cast(word, truth);
}

// The first flag with a value that says neither yes nor no.
std::string needless_value(const CommandDescription& command, const CLI::App& given) {
  for (const OptionDescription& option : command.options) {
    const std::vector<std::string>& values = given["--" + option.name]->results();
    if (option.is_flag() && !std::all_of(values.begin(), values.end(), reads_as_truth))
      return fmt::format("--{} takes no value", option.name);
  }
  return "";
}

// The first two options of which one lacks or excludes the other.
std::string wrong_pair(const CommandDescription& command, const CLI::App& given, bool excludes) {
  const auto is_given = [&](const std::string& name) { return given.count("--" + name) > 0; };
  for (const OptionDescription& option : command.options) {
    if (!is_given(option.name)) continue;
    for (const std::string& other : excludes ? option.excludes : option.needs) {
      if (is_given(other) != excludes) continue;
      if (excludes) return fmt::format("--{} and --{} do not go together", option.name, other);
      for (const OptionDescription& needed : command.options)
        if (needed.name == other)
          return fmt::format("--{} needs {}", option.name, needed.as_given());
    }
  }
  return "";
}

}  // namespace

std::string usage_sentence(const std::vector<std::string>& words, const CLI::App& app,
                           const std::vector<CommandDescription>& commands,
                           const CLI::ParseError& error) {
  std::string sentence = unknown_command(words, app);
  if (!sentence.empty() || app.get_subcommands().empty())
    return sentence.empty() ? error.what() : sentence;
  const CLI::App& given = *app.get_subcommands().front();
  sentence = unknown_option(given);
  if (!sentence.empty()) return sentence;
  const CommandDescription& command =
      *std::find_if(commands.begin(), commands.end(),
                    [&](const CommandDescription& one) { return one.name == given.get_name(); });
  const auto is = [&](CLI::ExitCodes kind) {
    return error.get_exit_code() == static_cast<int>(kind);
  };
  if (is(CLI::ExitCodes::RequiredError)) sentence = missing_options(command, given);
  if (is(CLI::ExitCodes::ExtrasError)) sentence = needless_words(command, given);
  if (is(CLI::ExitCodes::ArgumentMismatch))
    sentence = wrong_number_of_values(command, given, words.back());
  if (is(CLI::ExitCodes::ConversionError)) sentence = needless_value(command, given);
  if (is(CLI::ExitCodes::ExcludesError)) sentence = wrong_pair(command, given, true);
  if (is(CLI::ExitCodes::RequiresError)) sentence = wrong_pair(command, given, false);
  return sentence.empty() ? error.what() : sentence;
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

std::string no_command(const std::string& word, const CLI::App& app) {
  const std::string close = closest_name(word, commands_of(app));
  return close.empty() ? fmt::format("'{}' is no command", word)
                       : fmt::format("'{}' is no command; did you mean '{}'?", word, close);
}

}  // namespace graze
