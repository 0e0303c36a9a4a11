#include "graze/record/file/open_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "graze/base/errors.hpp"

namespace graze {
namespace {

constexpr std::size_t kBuffer = 64 * 1024;
// Largest number of programs that may write the same file at the same time.
constexpr int kNames = 1000;

// Whether the open file still has that name, no other name, and is of this user.
bool is_ours(int descriptor, const std::string& name) {
  struct stat open {
  }, named{};
  return ::fstat(descriptor, &open) == 0 && ::lstat(name.c_str(), &named) == 0 &&
         open.st_dev == named.st_dev && open.st_ino == named.st_ino && S_ISREG(open.st_mode) &&
         open.st_nlink == 1 && open.st_uid == ::geteuid();
}

// Opens the file of that name for this program alone, empty. Returns -1 when another program has
// it, or when it may not be overwritten; sets `error` when it cannot be opened at all.
int open_alone(const std::string& name, int& error) {
  // Does not wait for a pipe of that name; the umask applies to the mode.
  const int descriptor =
      ::open(name.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC,
             S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH);
  if (descriptor < 0) {
    error = errno;
    return -1;
  }
  // Where the disk supports no locks there are none. The name is checked with the lock held: until
  // then another program may have moved this file to its place.
  const bool locked = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
  if (locked && is_ours(descriptor, name) && ::ftruncate(descriptor, 0) == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

}  // namespace

OpenFile::OpenFile(std::filesystem::path file) : path_(std::move(file)) {
  int error = 0;
  for (int i = 1; i <= kNames && descriptor_ < 0; ++i) {
    written_as_ = path_.string() + ".unfinished" + (i == 1 ? "" : fmt::format("-{}", i));
    error = EEXIST;
    descriptor_ = open_alone(written_as_, error);
    // A link or a folder of that name only prevents the use of that name.
    const bool taken = error == EEXIST || error == ELOOP || error == EISDIR || error == ENXIO ||
                       (error == EACCES && ::access(written_as_.c_str(), F_OK) == 0);
    if (descriptor_ < 0 && !taken) break;
  }
  if (descriptor_ < 0) fail(error);
}

OpenFile::~OpenFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

OpenFile::OpenFile(OpenFile&& other) noexcept
    : path_(std::move(other.path_)),
      written_as_(std::move(other.written_as_)),
      buffer_(std::move(other.buffer_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

void OpenFile::fail(int error) const {
  throw FileError(fmt::format("{}: cannot write: {}", path_.string(), std::strerror(error)));
}

void OpenFile::append(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= kBuffer) flush();
}

void OpenFile::flush() {
  std::size_t done = 0;
  while (done < buffer_.size()) {
    const ssize_t count = ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(errno);
    done += static_cast<std::size_t>(count);
  }
  buffer_.clear();
}

void OpenFile::sync() {
  flush();
  if (::fsync(descriptor_) != 0) fail(errno);
}

std::string OpenFile::read(std::size_t position, std::size_t size) const {
  std::string text(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count =
        ::pread(descriptor_, text.data() + done, size - done, static_cast<off_t>(position + done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      throw FileError(fmt::format("{}: cannot read: {}", path_.string(), std::strerror(errno)));
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  text.resize(done);
  return text;
}

}  // namespace graze
