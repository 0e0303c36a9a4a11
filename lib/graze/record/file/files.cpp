#include "graze/record/file/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

#include "graze/base/detail/named_pipe.hpp"
#include "graze/base/errors.hpp"

namespace graze {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* action, int error) {
  throw FileError(fmt::format("{}: cannot {}: {}", path.string(), action, std::strerror(error)));
}

}  // namespace

PendingFile::PendingFile(PendingFile&& other) noexcept
    : file_(std::move(other.file_)), pending_(std::exchange(other.pending_, false)) {}

PendingFile::~PendingFile() {
  if (pending_) ::unlink(file_.written_as().c_str());
}

void PendingFile::commit() {
  file_.sync();
  if (std::rename(file_.written_as().c_str(), file_.path().c_str()) != 0)
    fail(file_.path(), "write", errno);
  pending_ = false;
}

void write_file(const std::filesystem::path& file, std::string_view text) {
  PendingFile pending(file);
  pending.append(text);
  pending.commit();
}

void read_pieces(const std::filesystem::path& file,
                 const std::function<bool(std::string_view)>& use) {
  std::error_code no_matter;  // ignored: a file that cannot be inspected cannot be opened either
  if (std::filesystem::is_directory(file, no_matter)) fail(file, "read", EISDIR);
  if (is_named_pipe(file))
    throw InputError(
        fmt::format("{}: cannot be read, it is a named pipe and no regular file", file.string()));
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) fail(file, "read", errno != 0 ? errno : EIO);
  std::string piece(64 * 1024, '\0');
  bool goes_on = true;
  while (stream && goes_on) {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    goes_on = use(std::string_view(piece).substr(0, static_cast<std::size_t>(stream.gcount())));
  }
  if (stream.bad()) fail(file, "read", EIO);
}

std::string read_file(const std::filesystem::path& file, std::size_t most) {
  std::string text;
  read_pieces(file, [&](std::string_view piece) {
    text += piece;
    return text.size() <= most;
  });
  if (text.size() > most) text.resize(most + 1);
  return text;
}

void check_folder(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder)) fail(folder, "write into the folder", ENOENT);
  if (!std::filesystem::is_directory(folder)) fail(folder, "write into the folder", ENOTDIR);
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(folder, "write into the folder", errno);
}

void prepare_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) fail(folder, "make the folder", error.value());
  check_folder(folder);
}

}  // namespace graze
