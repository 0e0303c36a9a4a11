#include "graze/record/files.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "graze/base/errors.hpp"

namespace graze {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* action, int error) {
  throw FileError(fmt::format("{}: cannot {}: {}", path.string(), action, std::strerror(error)));
}

void write_all(int descriptor, const std::string& text, const std::filesystem::path& path) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::write(descriptor, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path, "write", errno);
    done += static_cast<std::size_t>(count);
  }
}

}  // namespace

void write_file(const std::filesystem::path& file, const std::string& text) {
  std::string temporary = file.string() + ".XXXXXX";
  const int descriptor = ::mkstemp(temporary.data());
  if (descriptor < 0) fail(file, "write", errno);
  try {
    write_all(descriptor, text, file);
    // mkstemp makes files that only their owner reads; results are for everyone the umask allows.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    if (::fchmod(descriptor, 0666 & ~mask) != 0 || ::fsync(descriptor) != 0)
      fail(file, "write", errno);
  } catch (...) {
    ::close(descriptor);
    ::unlink(temporary.c_str());
    throw;
  }
  if (::close(descriptor) != 0 || ::rename(temporary.c_str(), file.c_str()) != 0) {
    const int error = errno;
    ::unlink(temporary.c_str());
    fail(file, "write", error);
  }
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
