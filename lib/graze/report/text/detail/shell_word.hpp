// A word as a shell takes it, for commands that are shown to be copied.
#pragma once

#include <string>

namespace graze {

// In quotes where a shell would read it otherwise.
std::string shell_word(const std::string& word);

}  // namespace graze
