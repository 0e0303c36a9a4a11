// Rows of numbers that grow while a run goes on, in one piece of memory that NumPy looks into.
#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace graze {

class Rows {
 public:
  // With room for so many rows, as far as the system lets one ask for it; only what is written is
  // taken.
  explicit Rows(std::vector<std::string> columns, double rows = 0.0)
      : columns_(std::move(columns)) {
    constexpr double kMost = 0x1p30;  // 8 GiB
    const auto wanted =
        static_cast<std::size_t>(std::min(rows * static_cast<double>(columns_.size()), kMost));
    if (wanted > kLarge) static_cast<void>(resize(wanted));
  }
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;
  ~Rows() {
    if (data_) ::munmap(data_, capacity_ * sizeof(double));
  }

  const std::vector<std::string>& columns() const { return columns_; }
  std::size_t count() const { return size_ / columns_.size(); }
  const double* data() const { return data_; }

  // Room for one more row, of as many numbers as there are columns, to be written at once.
  double* add() {
    if (size_ + columns_.size() > capacity_) grow();
    double* const row = data_ + size_;
    size_ += columns_.size();
    return row;
  }

 private:
  // The system moves memory by its pages, not by its bytes as a vector would, and hands out large
  // pages, where it has them, in a fraction of the time.
  void grow() {
    constexpr std::size_t kFirst = 4096;
    const std::size_t least = size_ + columns_.size();
    if (!resize(std::max({kFirst, least, capacity_ + capacity_ / 2}))) throw std::bad_alloc();
  }

  // Whether there is room for so many numbers now.
  bool resize(std::size_t wanted) {
    void* const moved =
        data_ ? ::mremap(data_, capacity_ * sizeof(double), wanted * sizeof(double), MREMAP_MAYMOVE)
              : ::mmap(nullptr, wanted * sizeof(double), PROT_READ | PROT_WRITE,
                       MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (moved == MAP_FAILED) return false;
    data_ = static_cast<double*>(moved);
    capacity_ = wanted;
    if (capacity_ >= kLarge)
      static_cast<void>(::madvise(data_, capacity_ * sizeof(double), MADV_HUGEPAGE));
    return true;
  }

  static constexpr std::size_t kLarge = std::size_t{1} << 20;  // numbers

  std::vector<std::string> columns_;
  double* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;  // numbers
};

}  // namespace graze
