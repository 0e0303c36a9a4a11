#include "graze/base/histogram.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace graze {
namespace {

constexpr std::size_t kBins = 4096;

// The smallest power of two above `value`.
double power_above(double value) {
  int exponent = 0;
  std::frexp(value, &exponent);
  return std::ldexp(1.0, exponent);
}

}  // namespace

void Histogram::add(double value) {
  if (!std::isfinite(value)) return;
  if (count_ == 0) lowest_ = highest_ = value;
  widen_to(value);
  ++count_;
  lowest_ = std::min(lowest_, value);
  highest_ = std::max(highest_, value);
  if (width_ > 0.0) ++bins_[static_cast<std::size_t>(std::floor(value / width_) - first_)];
}

void Histogram::widen_to(double value) {
  if (width_ == 0.0) {
    if (value == lowest_) return;
    // Bins are not finer than the values are, and their indices whole numbers.
    const double size = std::max(std::abs(value), std::abs(lowest_));
    // Halves, as the difference of the largest doubles is none.
    width_ = std::max({power_above(std::abs(0.5 * value - 0.5 * lowest_) / (kBins / 4)),
                       power_above(size * std::numeric_limits<double>::epsilon()),
                       std::numeric_limits<double>::min()});
    first_ = std::floor(std::min(value, lowest_) / width_);
    bins_.assign(kBins, 0);
    bins_[static_cast<std::size_t>(std::floor(lowest_ / width_) - first_)] = count_;
    return;
  }
  for (;;) {
    const double at = std::floor(value / width_);
    const double first = std::min(first_, at);
    const double last = std::max(std::floor(highest_ / width_), at);
    if (last - first < static_cast<double>(kBins)) {
      // Only bins without counts leave at the end.
      const auto shift = static_cast<std::ptrdiff_t>(first_ - first);
      std::rotate(bins_.begin(), bins_.end() - shift, bins_.end());
      first_ = first;
      return;
    }
    const double wide = std::floor(0.5 * first_);
    std::vector<long long> merged(kBins, 0);
    for (std::size_t k = 0; k < kBins; ++k)
      if (bins_[k] > 0)
        merged[static_cast<std::size_t>(std::floor(0.5 * (first_ + static_cast<double>(k))) -
                                        wide)] += bins_[k];
    bins_ = std::move(merged);
    first_ = wide;
    width_ *= 2.0;
  }
}

double Histogram::exceeded(double share) const {
  if (count_ == 0) return std::numeric_limits<double>::quiet_NaN();
  double left = share * static_cast<double>(count_);
  for (std::size_t k = bins_.size(); k-- > 0;) {
    const auto here = static_cast<double>(bins_[k]);
    if (here > 0.0 && here >= left)
      return std::clamp((first_ + static_cast<double>(k) + 1.0 - left / here) * width_, lowest_,
                        highest_);
    left -= here;
  }
  return lowest_;
}

BinCounts Histogram::from_zero(int most) const {
  BinCounts result;
  if (count_ == 0) return result;
  result.width = std::max(power_above(highest_ / most), width_);
  result.counts.resize(static_cast<std::size_t>(highest_ / result.width) + 1);
  if (width_ == 0.0) result.counts.back() = count_;
  for (std::size_t k = 0; k < bins_.size(); ++k)
    if (bins_[k] > 0)
      result.counts[static_cast<std::size_t>((first_ + static_cast<double>(k)) * width_ /
                                             result.width)] += bins_[k];
  return result;
}

}  // namespace graze
