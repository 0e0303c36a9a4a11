// Words as a shell takes them, for commands that are shown to be copied.
#pragma once

#include <string>
#include <vector>

namespace graze {

// In quotes where a shell would read it otherwise.
std::string shell_word(const std::string& word);

// The program, itself such words, with these arguments.
std::string shell_command(const std::vector<std::string>& arguments,
                          const std::string& program = "graze");

}  // namespace graze
