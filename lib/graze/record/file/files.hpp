// Files that are written completely or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "graze/record/file/open_file.hpp"

namespace graze {

// A file that is written beside its place under another name and moved to its place when it is
// complete. Until then, and if it never is, an older file stays there, and nothing else is left
// behind. All functions throw FileError.
class PendingFile {
 public:
  explicit PendingFile(const std::filesystem::path& file) : file_(file) {}
  ~PendingFile();
  PendingFile(PendingFile&& other) noexcept;
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  void append(std::string_view text) { file_.append(text); }
  // Puts all of it on the disk, so that little can go wrong in `commit`.
  void sync() { file_.sync(); }
  void commit();

 private:
  OpenFile file_;
  bool pending_ = true;
};

// Writes `text` as the whole content of `file`. Throws FileError, leaving `file` as it was.
void write_file(const std::filesystem::path& file, std::string_view text);

// Passes the file's content piece by piece to `use` while that returns true. Throws FileError, and
// InputError for a named pipe (named_pipe.hpp).
void read_pieces(const std::filesystem::path& file,
                 const std::function<bool(std::string_view)>& use);

// The file's content, but at most `most` + 1 bytes. Throws as read_pieces does.
std::string read_file(const std::filesystem::path& file, std::size_t most);

// Checks that the folder is there and that files can be made in it. Throws FileError.
void check_folder(const std::filesystem::path& folder);

// Makes the folder (and its parents) unless it is there, then checks it. Throws FileError.
void prepare_folder(const std::filesystem::path& folder);

}  // namespace graze
