#include "graze/base/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace graze {
namespace {

// The transform of the values without their mean, under Hann's window, periodic: a line between two
// frequencies spreads over four of them.
std::vector<std::complex<double>> transformed(const double* values, std::size_t count) {
  double mean = 0.0;
  for (std::size_t i = 0; i < count; ++i) mean += values[i] / static_cast<double>(count);
  std::vector<double> windowed(count);
  for (std::size_t i = 0; i < count; ++i)
    windowed[i] = (values[i] - mean) * 0.5 *
                  (1.0 - std::cos(2.0 * std::numbers::pi * static_cast<double>(i) /
                                  static_cast<double>(count)));
  // Kept, as it has the factors of the lengths that it has met.
  thread_local Eigen::FFT<double> fft;
  std::vector<std::complex<double>> result;
  fft.fwd(result, windowed);
  return result;
}

std::size_t largest_prime_factor(std::size_t number) {
  std::size_t largest = 1;
  for (std::size_t factor = 2; factor * factor <= number; ++factor)
    while (number % factor == 0) number /= largest = factor;
  return std::max(largest, number);
}

}  // namespace

Spectrum amplitude_spectrum(const std::vector<double>& values, double rate) {
  Spectrum spectrum;
  const std::size_t count = values.size();
  if (count < 4) return spectrum;
  const std::vector<std::complex<double>> lines = transformed(values.data(), count);
  // Twice for the negative frequencies, twice for the window's mean of a half.
  for (std::size_t k = 1; k < count / 2; ++k) {
    spectrum.frequency.push_back(rate * static_cast<double>(k) / static_cast<double>(count));
    spectrum.amplitude.push_back(4.0 * std::abs(lines[k]) / static_cast<double>(count));
  }
  return spectrum;
}

PowerSpectrum::PowerSpectrum(std::size_t segment, double rate)
    : segment_(segment), rate_(rate), power_(segment / 2 + 1) {
  values_.reserve(segment);
}

void PowerSpectrum::add(double value) {
  values_.push_back(value);
  if (values_.size() < segment_) return;
  const std::vector<std::complex<double>> lines = transformed(values_.data(), segment_);
  for (std::size_t k = 0; k < power_.size(); ++k) power_[k] += std::norm(lines[k]);
  ++segments_;
  values_.erase(values_.begin(), values_.begin() + static_cast<std::ptrdiff_t>(segment_ / 2));
}

std::vector<double> PowerSpectrum::density() const {
  if (segments_ == 0) return {};
  // The squares of the window sum to three eighths of its length.
  const double scale =
      1.0 / (rate_ * 0.375 * static_cast<double>(segment_) * static_cast<double>(segments_));
  std::vector<double> density = power_;
  for (std::size_t k = 0; k < density.size(); ++k)
    density[k] *= k == 0 || k + 1 == density.size() ? scale : 2.0 * scale;
  return density;
}

std::size_t segment_length(double most) {
  // The transform costs as many operations a sample as the sum of the prime factors, and the number
  // of forcing periods, which lines of their own need, is mostly one of these.
  constexpr std::size_t kLargestFactor = 64;
  auto length = static_cast<std::size_t>(std::clamp(most, 4.0, 0x1p40)) / 2 * 2;
  while (largest_prime_factor(length) > kLargestFactor) length -= 2;
  return length;
}

}  // namespace graze
