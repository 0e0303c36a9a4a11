// From words to a command, for a shell and for a caller in the process.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "command.hpp"
#include "graze/base/detail/terminal_text.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/file/run_info.hpp"
#include "help_format.hpp"
#include "option_groups.hpp"
#include "session.hpp"
#include "usage_errors.hpp"

namespace graze {

struct CommandReader::Parser {
  CLI::App app{"Graze: impacting flexible structures - motion, periodic orbits, branches", "graze"};
  std::optional<Command> parsed{};
  std::optional<std::string> answer{};  // of a command that only prints: help, version

  // Throws what the parser throws, and InputError.
  void parse(const std::vector<std::string>& words);
};

namespace {

void add_answers(CLI::App& app, std::optional<std::string>& answer) {
  CLI::App* help = app.add_subcommand("help", "Print what a command does, and its options");
  const auto command = std::make_shared<std::string>();
  help->add_option("COMMAND", *command, "One of the commands (default: a list of them)");
  help->preparse_callback([command](std::size_t) { command->clear(); });
  help->callback([&app, &answer, command] {
    const CLI::App* asked = command->empty() ? &app : nullptr;
    for (const CLI::App* each : app.get_subcommands({}))
      if (each->get_name() == *command) asked = each;
    if (!asked) throw InputError(no_command(*command, app));
    // The program's own help() would be that of the command given, which is this one.
    answer = app.get_formatter()->make_help(
        asked, asked == &app ? "graze" : "graze " + asked->get_name(), CLI::AppFormatMode::Normal);
  });
  CLI::App* version_word = app.add_subcommand("version", "Print the version");
  version_word->callback([&answer] { answer = "graze " + version() + "\n"; });
  for (CLI::App* added : {help, version_word}) added->get_help_ptr()->group(kOutputGroup);
}

// With short options written out, so that whoever reads the words later finds one name of each.
std::vector<std::string> with_long_names(const std::vector<std::string>& words,
                                         const CLI::App& command) {
  std::vector<std::string> written;
  bool reads_options = true;
  for (const std::string& word : words) {
    reads_options = reads_options && word != "--";
    const auto option = [&](std::size_t at) {
      return command.get_option_no_throw({'-', word[at]});
    };
    if (!reads_options || word.size() < 2 || word[0] != '-' || word[1] == '-' || !option(1)) {
      written.push_back(word);
      continue;
    }
    for (std::size_t at = 1; at < word.size() && option(at); ++at) {
      written.push_back(option(at)->get_name());
      if (option(at)->get_expected_max() == 0) continue;
      if (at + 1 < word.size()) written.back() += "=" + word.substr(at + 1);
      break;
    }
  }
  return written;
}

}  // namespace

void CommandReader::Parser::parse(const std::vector<std::string>& words) {
  parsed.reset(), answer.reset();
  // The parser takes its words from the back.
  app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  const CLI::App& given = *app.get_subcommands().front();
  if (const std::string empty = empty_option(given); !empty.empty())
    throw CLI::ValidationError(empty);
  if (parsed)
    std::visit([&](CommonOptions& command) { command.arguments = with_long_names(words, given); },
               *parsed);
}

CommandReader::CommandReader() : parser_(std::make_unique<Parser>()) {
  CLI::App& app = parser_->app;
  app.set_version_flag("--version", "graze " + version());
  app.formatter(std::make_shared<HelpFormat>());
  app.set_help_flag("-h,--help", "Print this help");
  app.require_subcommand(1);
  app.footer(
      footer("orbit data/scenes/05_wagg_one_mode.toml --set forcing.frequency=40\n"
             "graze COMMAND --help, or graze help COMMAND, lists the options of a command."));
  add_commands(app, parser_->parsed);
  add_answers(app, parser_->answer);
}

CommandReader::~CommandReader() = default;

Command CommandReader::read(const std::vector<std::string>& words) {
  try {
    parser_->parse(words);
  } catch (const CLI::Success&) {
    parser_->parsed.reset();
  } catch (const CLI::ParseError& error) {
    throw InputError(usage_sentence(words, parser_->app, error));
  }
  if (!parser_->parsed) throw InputError("help and version are printed by the program alone");
  return *parser_->parsed;
}

namespace {

CommandReader::Option told(const CLI::Option& option) {
  CommandReader::Option told;
  told.name = option.get_name(option.get_positional());
  if (!option.get_positional()) told.name.erase(0, 2);
  told.what = option.get_description();
  told.default_value = option.get_default_str();
  told.is_flag = option.get_expected_max() == 0;
  told.takes_several = option.get_expected_max() > 1;
  if (!option.get_snames().empty()) told.short_name = option.get_snames().front();
  const std::string shown = with_placeholder(option);
  if (const std::size_t blank = shown.find(' '); blank != std::string::npos)
    told.placeholder = shown.substr(blank + 1);
  told.choices = choices_of(option);
  told.heading = option.get_group();
  told.help = help_line(option);
  told.is_required = option.get_required();
  return told;
}

}  // namespace

std::vector<CommandReader::Option> CommandReader::options(const std::string& command) const {
  for (const Description& known : descriptions())
    if (known.name == command) return known.options;
  return {};
}

std::vector<CommandReader::Description> CommandReader::descriptions() const {
  std::vector<Description> list;
  for (const CLI::App* app : parser_->app.get_subcommands({})) {
    Description command{
        app->get_name(), app->get_description(), example_in(app->get_footer()), {}, {}};
    for (const CLI::Option* option : app->get_options())
      if (option != app->get_help_ptr())
        (option->get_positional() ? command.files : command.options).push_back(told(*option));
    list.push_back(std::move(command));
  }
  return list;
}

ParsedCommand parse_command_line(int argc, char** argv) {
  CommandReader reader;
  CommandReader::Parser& parser = *reader.parser_;
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  try {
    parser.parse(words);
  } catch (const CLI::Success& done) {  // --help, --version
    return {std::nullopt, parser.app.exit(done) == 0 ? 0 : 2};
  } catch (const CLI::ParseError& error) {
    const auto& given = parser.app.get_subcommands();
    std::cerr << "graze: " << terminal_line(usage_sentence(words, parser.app, error))
              << " (see graze " << (given.empty() ? "" : given.front()->get_name() + " ")
              << "--help)\n";
    return {std::nullopt, 2};
  } catch (const InputError& error) {
    std::cerr << "graze: " << terminal_line(error.what()) << "\n";
    return {std::nullopt, 2};
  }
  if (parser.answer) print([&](const TextSink& out) { out(*parser.answer); });
  return {parser.parsed, 0};
}

}  // namespace graze
