// Named pipes, which may block whoever opens them.
#pragma once

#include <filesystem>

namespace graze {

// Whether the file is a pipe with a name of its own: opening it waits for a writer, who may never
// come. False for a pipe that the calling program opened already (/dev/stdin, and those of
// <(command) below /dev/fd), and for a file that does not exist.
bool is_named_pipe(const std::filesystem::path& file);

}  // namespace graze
