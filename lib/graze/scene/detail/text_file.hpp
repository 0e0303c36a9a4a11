// A whole file as text.
#pragma once

#include <filesystem>
#include <string>

namespace graze {

// Of a file with more than kLargestText bytes (text_check.hpp) it reads little more than these, so
// that the caller finds it too large; an endless stream ends there as well. `kind` names the file
// in messages: "a scene". Throws FileError, and InputError for a named pipe (named_pipe.hpp).
std::string read_text_file(const std::filesystem::path& file, const std::string& kind);

}  // namespace graze
