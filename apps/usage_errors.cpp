#include "usage_errors.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "graze/scene/detail/suggestion.hpp"

namespace graze {
namespace {

bool is(const CLI::ParseError& error, CLI::ExitCodes kind) {
  return error.get_exit_code() == static_cast<int>(kind);
}

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
std::string needless_words(const CLI::App& command) {
  std::vector<std::string> files, words;
  bool has_setting = false;
  for (const CLI::Option* option : command.get_options())
    if (option->get_positional()) files.push_back(option->get_name());
  for (const std::string& word : command.remaining()) {
    words.push_back(fmt::format("'{}'", word));
    has_setting = has_setting || word.find('=') != std::string::npos;
  }
  // The parser has them from the last to the first.
  std::reverse(words.begin(), words.end());
  return fmt::format("{} takes {}; {} {} too many{}", command.get_name(),
                     files.empty() ? "no words but options" : joined(files, "and"),
                     joined(words, "and"), words.size() == 1 ? "is" : "are",
                     has_setting ? ", each setting has a --set of its own" : "");
}

std::string wrong_number_of_values(const CLI::Option& option) {
  const std::size_t given = option.results().size();
  if (given <= 1)
    return fmt::format("{}: the value is missing; give {}", option.get_name(),
                       with_placeholder(option));
  return fmt::format("{} was given {}; it takes one value", option.get_name(),
                     given == 2 ? "twice" : fmt::format("{} times", given));
}

std::string missing_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    if (option->get_required() && option->count() == 0) names.push_back(with_placeholder(*option));
  return names.empty()
             ? ""
             : fmt::format("{} {} missing", joined(names, "and"), names.size() == 1 ? "is" : "are");
}

std::string no_choice(const CLI::Option& option) {
  const std::vector<std::string> choices = choices_of(option);
  for (const std::string& value : option.results())
    if (std::find(choices.begin(), choices.end(), value) == choices.end())
      return fmt::format("{}: '{}' is not allowed; give {}", option.get_name(), value,
                         joined(choices, "or"));
  return "";
}

// Where the parser's own words name one option, or two with a word between.
std::string option_sentence(const CLI::App& command, const CLI::ParseError& error) {
  const std::string told = error.what();
  const auto option = [&](const std::string& name) { return command.get_option_no_throw(name); };
  // "Could not convert: --json = 3,x" or "--json: ..", "--show requires --plot".
  const std::string before = "Could not convert: ";
  const std::string from_name = told.rfind(before, 0) == 0 ? told.substr(before.size()) : told;
  const CLI::Option* const first = option(from_name.substr(0, from_name.find_first_of(": ")));
  const CLI::Option* const last = option(told.substr(told.rfind(' ') + 1));
  if (!first) return "";
  if (is(error, CLI::ExitCodes::ArgumentMismatch)) return wrong_number_of_values(*first);
  if (is(error, CLI::ExitCodes::ValidationError) && !choices_of(*first).empty())
    return no_choice(*first);
  if (is(error, CLI::ExitCodes::ConversionError) && first->get_expected_max() == 0)
    return fmt::format("{} takes no value", first->get_name());
  if (last && is(error, CLI::ExitCodes::ExcludesError))
    return fmt::format("{} and {} do not go together", first->get_name(), last->get_name());
  if (last && is(error, CLI::ExitCodes::RequiresError))
    return fmt::format("{} needs {}", first->get_name(), with_placeholder(*last));
  return "";
}

}  // namespace

std::string usage_sentence(const std::vector<std::string>& words, const CLI::App& app,
                           const CLI::ParseError& error) {
  std::string sentence = unknown_command(words, app);
  if (sentence.empty() && !app.get_subcommands().empty()) {
    const CLI::App& command = *app.get_subcommands().front();
    sentence = unknown_option(command);
    if (!sentence.empty()) return sentence;
    if (is(error, CLI::ExitCodes::RequiredError))
      sentence = missing_options(command);
    else if (is(error, CLI::ExitCodes::ExtrasError))
      sentence = needless_words(command);
    else
      sentence = option_sentence(command, error);
  }
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

std::string with_placeholder(const CLI::Option& option) {
  if (option.get_positional() || option.get_type_size() == 0) return option.get_name();
  const std::string type = option.get_type_name();
  return option.get_name() + " " + type.substr(0, type.find(":{"));
}

std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find(":{");
  if (begin == std::string::npos) return {};
  return CLI::detail::split(type.substr(begin + 2, type.rfind('}') - begin - 2), ',');
}

}  // namespace graze
