// Manual pages, in the words of the program's --help.
#pragma once

#include <string>
#include <vector>

#include "command.hpp"

namespace graze {

// graze(1), which lists the commands.
std::string man_page(const std::vector<CommandDescription>& commands, const std::string& version);
// graze-mpi(1), which lists those of them whose work ranks share.
std::string man_page_of_ranks(const std::vector<CommandDescription>& commands,
                              const std::string& version);
// graze-COMMAND(1).
std::string man_page(const CommandDescription& command, const std::string& version);

}  // namespace graze
