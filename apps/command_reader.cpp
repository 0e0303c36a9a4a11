// From words to a command, for a shell and for a caller in the process.
#include <CLI/CLI.hpp>
#include <iostream>

#include "command.hpp"
#include "graze/base/detail/terminal_text.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/file/run_info.hpp"
#include "help_format.hpp"
#include "option_groups.hpp"
#include "usage_errors.hpp"

namespace graze {

struct CommandReader::Parser {
  CLI::App app{"Graze: impacting flexible structures - motion, periodic orbits, branches", "graze"};
  std::optional<Command> parsed{};
};

CommandReader::CommandReader() : parser_(std::make_unique<Parser>()) {
  CLI::App& app = parser_->app;
  app.set_version_flag("--version", "graze " + version());
  app.formatter(std::make_shared<HelpFormat>());
  app.set_help_flag("-h,--help", "Print this help");
  app.require_subcommand(1);
  app.footer(
      footer("orbit data/scenes/05_wagg_one_mode.toml --set forcing.frequency=40\n"
             "graze COMMAND --help lists the options of a command."));
  add_commands(app, parser_->parsed);
}

CommandReader::~CommandReader() = default;

Command CommandReader::read(const std::vector<std::string>& words) {
  CLI::App& app = parser_->app;
  parser_->parsed.reset();
  try {
    // The parser takes its words from the back.
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::Success&) {
    throw InputError("help and version are printed by the program alone");
  } catch (const CLI::ParseError& error) {
    const std::string unknown = unknown_option(app);
    throw InputError(unknown.empty() ? error.what() : unknown);
  }
  if (const std::string empty = empty_option(*app.get_subcommands().front()); !empty.empty())
    throw InputError(empty);
  std::visit([&](CommonOptions& command) { command.arguments = words; }, *parser_->parsed);
  return *parser_->parsed;
}

std::vector<CommandReader::Option> CommandReader::options(const std::string& command) const {
  std::vector<Option> list;
  for (const CLI::App* app : parser_->app.get_subcommands({})) {
    if (app->get_name() != command) continue;
    for (const CLI::Option* option : app->get_options()) {
      if (option->get_positional() || option == app->get_help_ptr()) continue;
      list.push_back({option->get_name().substr(2), option->get_description(),
                      option->get_default_str(), option->get_expected_max() == 0,
                      option->get_expected_max() > 1});
    }
  }
  return list;
}

ParsedCommand parse_command_line(int argc, char** argv) {
  CommandReader reader;
  CLI::App& app = reader.parser_->app;
  std::optional<Command>& parsed = reader.parser_->parsed;
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {  // help, version
    return {std::nullopt, app.exit(done) == 0 ? 0 : 2};
  } catch (const CLI::ParseError& error) {
    std::string unknown = unknown_command(argc, argv, app);
    if (unknown.empty()) unknown = unknown_option(app);
    const auto& commands = app.get_subcommands();
    std::cerr << "graze: " << terminal_line(unknown.empty() ? error.what() : unknown)
              << " (see graze " << (commands.empty() ? "" : commands.front()->get_name() + " ")
              << "--help)\n";
    return {std::nullopt, 2};
  } catch (const InputError& error) {
    std::cerr << "graze: " << terminal_line(error.what()) << "\n";
    return {std::nullopt, 2};
  }
  const CLI::App& given = *app.get_subcommands().front();
  if (const std::string empty = empty_option(given); !empty.empty()) {
    std::cerr << "graze: " << empty << " (see graze " << given.get_name() << " --help)\n";
    return {std::nullopt, 2};
  }
  std::visit([&](CommonOptions& command) { command.arguments.assign(argv + 1, argv + argc); },
             *parsed);
  return {parsed, 0};
}

}  // namespace graze
