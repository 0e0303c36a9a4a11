// Rows of numbers that grow while a run goes on, in one piece of memory that NumPy looks into.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

namespace graze {

class Rows {
 public:
  Rows() = default;
  explicit Rows(std::vector<std::string> columns) : columns_(std::move(columns)) {}
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;
  ~Rows() { std::free(data_); }

  const std::vector<std::string>& columns() const { return columns_; }
  std::size_t count() const { return columns_.empty() ? 0 : size_ / columns_.size(); }
  const double* data() const { return data_; }

  // A row has as many numbers as there are columns.
  void add(const std::vector<double>& row) {
    if (size_ + row.size() > capacity_) grow(size_ + row.size());
    for (const double value : row) data_[size_++] = value;
  }

 private:
  // The system moves large pieces of memory by their pages, not by their bytes, which a vector
  // could not make use of.
  void grow(std::size_t least) {
    constexpr std::size_t kFirst = 1024;
    std::size_t wanted = capacity_ < kFirst ? kFirst : capacity_ + capacity_ / 2;
    if (wanted < least) wanted = least;
    void* moved = std::realloc(data_, wanted * sizeof(double));
    if (!moved) throw std::bad_alloc();
    data_ = static_cast<double*>(moved);
    capacity_ = wanted;
  }

  std::vector<std::string> columns_;
  double* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace graze
