// From words to a command, for a shell and for a caller in the process.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <type_traits>
#include <variant>

#include "command.hpp"
#include "command_line.hpp"
#include "graze/base/errors.hpp"
#include "graze/base/terminal_text.hpp"
#include "graze/record/file/run_info.hpp"
#include "help_format.hpp"
#include "session.hpp"
#include "usage_errors.hpp"

namespace graze {

namespace {

// Of the program, and of commands that only print.
constexpr const char* kExample =
    "orbit data/scenes/05_wagg_one_mode.toml --set forcing.frequency=40\n"
    "graze COMMAND --help, or graze help COMMAND, lists the options of a command.";

}  // namespace

struct CommandReader::Parser {
  CLI::App app{"Graze: impacting flexible structures - motion, periodic orbits, branches", "graze"};
  std::optional<Command> parsed{};
  std::optional<std::string> answer{};  // of a command that only prints: help, version
  std::vector<CommandDescription> commands{};

  // Throws what the parser throws, and InputError.
  void parse(const std::vector<std::string>& words);
  // A command, which becomes what is parsed where it is the one given.
  template <class Kind>
  void add_command();
  void add_answers();
};

template <class Kind>
void CommandReader::Parser::add_command() {
  const auto options = std::make_shared<Kind>();
  CommandLine line(app);
  describe(line, *options);
  line.conclude();
  const std::string name = line.description().name;
  // One reader may read any number of commands.
  line.app().preparse_callback([options, name](std::size_t) {
    *options = Kind();
    options->name = name;
  });
  line.app().callback([options, this] { parsed = *options; });
  commands.push_back(line.description());
}

void CommandReader::Parser::add_answers() {
  const auto asked_for = std::make_shared<std::string>();
  CommandLine help(app), version_word(app);
  help.command("help", "Print what a command does, and its options", kExample);
  help.file("COMMAND", *asked_for, "One of the commands (default: a list of them)");
  help.app().preparse_callback([asked_for](std::size_t) { asked_for->clear(); });
  help.app().callback([this, asked_for] {
    const CLI::App* asked = asked_for->empty() ? &app : nullptr;
    for (const CLI::App* each : app.get_subcommands({}))
      if (each->get_name() == *asked_for) asked = each;
    if (!asked) throw InputError(no_command(*asked_for, app));
    // The program's own help() would be that of the command given, which is this one.
    answer = app.get_formatter()->make_help(
        asked, asked == &app ? "graze" : "graze " + asked->get_name(), CLI::AppFormatMode::Normal);
  });
  version_word.command("version", "Print the version", kExample);
  version_word.app().callback([this] { answer = "graze " + version() + "\n"; });
  for (CommandLine* line : {&help, &version_word}) {
    line->conclude();
    commands.push_back(line->description());
  }
}

namespace {

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
  app.footer(footer(kExample));
  const auto add_all = [&]<class... Kinds>(std::type_identity<std::variant<Kinds...>>) {
    (parser_->add_command<Kinds>(), ...);
  };
  add_all(std::type_identity<Command>());
  parser_->add_answers();
}

CommandReader::~CommandReader() = default;

Command CommandReader::read(const std::vector<std::string>& words) {
  try {
    parser_->parse(words);
  } catch (const CLI::Success&) {
    parser_->parsed.reset();
  } catch (const CLI::ParseError& error) {
    throw InputError(usage_sentence(words, parser_->app, parser_->commands, error));
  }
  if (!parser_->parsed) throw InputError("help and version are printed by the program alone");
  return *parser_->parsed;
}

const std::vector<CommandDescription>& CommandReader::descriptions() const {
  return parser_->commands;
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
    std::cerr << "graze: "
              << terminal_line(usage_sentence(words, parser.app, parser.commands, error))
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
