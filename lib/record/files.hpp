// Files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <string>

namespace graze {

// Writes `text` beside `file` under another name, syncs it, and renames it into place. Throws
// FileError, leaving `file` as it was.
void write_file(const std::filesystem::path& file, const std::string& text);

// Checks that the folder is there and that files can be made in it. Throws FileError.
void check_folder(const std::filesystem::path& folder);

// Makes the folder (and its parents) unless it is there, then checks it. Throws FileError.
void prepare_folder(const std::filesystem::path& folder);

}  // namespace graze
