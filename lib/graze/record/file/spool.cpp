#include "graze/record/file/spool.hpp"

#include <unistd.h>

#include <algorithm>

#include "graze/base/errors.hpp"

namespace graze {
namespace {

constexpr std::size_t kLongest = 1024 * 1024;  // bytes in memory
constexpr std::size_t kSpoolPiece = 64 * 1024;

}  // namespace

Spool::Spool() {
  std::error_code error;
  folder_ = std::filesystem::temp_directory_path(error);
  if (error) folder_ = "/tmp";
}

void Spool::append(std::string_view text) {
  size_ += text.size();
  if (!file_) {
    short_ += text;
    if (short_.size() < kLongest) return;
    file_.emplace(folder_ / "graze_spool");
    ::unlink(file_->written_as().c_str());
    file_->append(short_);
    short_ = std::string();
    return;
  }
  file_->append(text);
}

void Spool::read(const TextSink& sink) {
  if (!file_) {
    if (!short_.empty()) sink(short_);
    return;
  }
  for (std::size_t done = 0; done < size_; done += kSpoolPiece)
    sink(piece(done, std::min(kSpoolPiece, size_ - done)));
}

std::string Spool::piece(std::size_t position, std::size_t size) {
  if (!file_) return short_.substr(position, size);
  file_->flush();
  std::string bytes = file_->read(position, size);
  if (bytes.size() < size)
    throw FileError(file_->path().string() + ": cannot read what was written");
  return bytes;
}

void Document::read(const TextSink& sink) const {
  sink(head);
  if (middle) middle->read(sink);
  if (!tail.empty()) sink(tail);
}

}  // namespace graze
