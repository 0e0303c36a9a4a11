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
  explicit Rows(std::vector<std::string> columns) : columns_(std::move(columns)) {}
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
    const std::size_t wanted = std::max({kFirst, least, capacity_ + capacity_ / 2});
    void* const moved =
        data_ ? ::mremap(data_, capacity_ * sizeof(double), wanted * sizeof(double), MREMAP_MAYMOVE)
              : ::mmap(nullptr, wanted * sizeof(double), PROT_READ | PROT_WRITE,
                       MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (moved == MAP_FAILED) throw std::bad_alloc();
    data_ = static_cast<double*>(moved);
    capacity_ = wanted;
    constexpr std::size_t kLarge = std::size_t{1} << 20;
    if (capacity_ >= kLarge)
      static_cast<void>(::madvise(data_, capacity_ * sizeof(double), MADV_HUGEPAGE));
  }

  std::vector<std::string> columns_;
  double* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;  // numbers
};

}  // namespace graze
