// The page docs/commands.md: every command with its options, in the words of the program's --help.
#pragma once

#include <string>
#include <vector>

#include "command.hpp"

namespace graze {

// As Markdown; options that several commands have in the same words stand once, at the end.
std::string command_reference(const std::vector<CommandDescription>& commands);

}  // namespace graze
