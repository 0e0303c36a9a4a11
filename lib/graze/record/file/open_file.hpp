// A file that is being written, with a buffer in front of it.
//
// It is written beside its place as `<file>.unfinished`, which a lock of the system marks as in
// use. The lock ends with the program in any case: the next program overwrites the file of a killed
// one, so that such files never accumulate. Where that name is in use by a running program, or may
// not be overwritten, `<file>.unfinished-2` and so on are tried.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace graze {

class OpenFile {
 public:
  // Makes a new file beside `file`, whose name messages give. Throws FileError.
  explicit OpenFile(std::filesystem::path file);
  ~OpenFile();  // closes; what is still in the buffer is dropped
  OpenFile(OpenFile&& other) noexcept;
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  // All throw FileError.
  void append(std::string_view text);
  void flush();
  void sync();  // flushes, and waits until the disk has it
  // Reads what was flushed, from `position` on; less than `size` bytes at its end only.
  std::string read(std::size_t position, std::size_t size) const;

  const std::filesystem::path& path() const { return path_; }
  // The name under which it is written.
  const std::string& written_as() const { return written_as_; }

 private:
  [[noreturn]] void fail(int error) const;

  std::filesystem::path path_;
  std::string written_as_;
  std::string buffer_;
  int descriptor_ = -1;
};

}  // namespace graze
