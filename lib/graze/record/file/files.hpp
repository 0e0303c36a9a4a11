// Files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "graze/record/file/open_file.hpp"

namespace graze {

// A file that grows beside its place under another name and takes it when it is complete. Until
// then, and if it never is, whatever stood there stays, and nothing else is left behind. All
// functions throw FileError.
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

// Hands out the file's content piece by piece while `use` says that it goes on. Throws FileError,
// and InputError for a named pipe (named_pipe.hpp).
void read_pieces(const std::filesystem::path& file,
                 const std::function<bool(std::string_view)>& use);

// The file's content, but no more than `most` bytes and one. Throws as read_pieces does.
std::string read_file(const std::filesystem::path& file, std::size_t most);

// Checks that the folder is there and that files can be made in it. Throws FileError.
void check_folder(const std::filesystem::path& folder);

// Makes the folder (and its parents) unless it is there, then checks it. Throws FileError.
void prepare_folder(const std::filesystem::path& folder);

}  // namespace graze
