// Files that may never begin.
#pragma once

#include <filesystem>

namespace graze {

// Whether the file is a pipe with a name of its own: to open it waits for someone to write, who may
// never come. Not one that was opened for the program by whoever called it: /dev/stdin, and those
// of <(command) below /dev/fd. False for what is not there.
bool is_named_pipe(const std::filesystem::path& file);

}  // namespace graze
