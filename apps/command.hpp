// What the user asked for, parsed and checked, before anything is done about it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "command_description.hpp"
#include "options/compare.hpp"
#include "options/scenes.hpp"
#include "options/simulate.hpp"
#include "options/stored.hpp"
#include "options/sweeping.hpp"
#include "options/tracing.hpp"

namespace graze {

using Command = std::variant<InitCommand, CheckCommand, ModesCommand, SimulateCommand, OrbitCommand,
                             ContinueCommand, DiagramCommand, MapCommand, MergeCommand, ViewCommand,
                             CostCommand, FitCommand, CompareCommand>;

struct ParsedCommand {
  std::optional<Command> command;
  int exit_code = 0;  // where there is no command: 0 after --help and --version, else 2
};

// Parses the command line. Help and version go to stdout, errors to stderr.
ParsedCommand parse_command_line(int argc, char** argv);

// Reads commands, one after the other.
class CommandReader {
 public:
  CommandReader();
  ~CommandReader();
  CommandReader(const CommandReader&) = delete;
  CommandReader& operator=(const CommandReader&) = delete;

  // Of the words after the program's name. Throws InputError with the sentence of the program.
  Command read(const std::vector<std::string>& words);
  // Of all commands, in the order of --help.
  const std::vector<CommandDescription>& descriptions() const;

 private:
  friend ParsedCommand parse_command_line(int argc, char** argv);
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace graze
