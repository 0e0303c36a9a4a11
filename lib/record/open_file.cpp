#include "graze/record/open_file.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "graze/base/errors.hpp"

namespace graze {
namespace {

constexpr std::size_t kBuffer = 64 * 1024;

}  // namespace

OpenFile::OpenFile(std::filesystem::path file)
    : path_(std::move(file)), written_as_(path_.string() + ".XXXXXX") {
  descriptor_ = ::mkstemp(written_as_.data());
  if (descriptor_ < 0) fail(errno);
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
  // mkstemp makes files that only their owner reads; results are for everyone the umask allows.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  if (::fchmod(descriptor_, 0666 & ~mask) != 0 || ::fsync(descriptor_) != 0) fail(errno);
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
