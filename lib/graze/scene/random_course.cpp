#include "graze/scene/detail/random_course.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <unsupported/Eigen/FFT>

#include "graze/base/angle.hpp"

namespace graze {

double SpectralDensity::at(double frequency) const {
  const auto above = std::upper_bound(frequencies.begin(), frequencies.end(), frequency);
  const auto k = static_cast<std::size_t>(above - frequencies.begin());
  if (k == 0) return 0.0;
  if (k == frequencies.size()) return frequency == frequencies.back() ? values.back() : 0.0;
  const double part = (frequency - frequencies[k - 1]) / (frequencies[k] - frequencies[k - 1]);
  return values[k - 1] + part * (values[k] - values[k - 1]);
}

std::shared_ptr<TimeCourse> drawn_course(const SpectralDensity& density, double duration, double step,
                                         unsigned seed, bool repeats) {
  const auto count = static_cast<std::size_t>(std::max(2.0, std::round(duration / step)));
  const double spacing = 1.0 / (static_cast<double>(count) * step);
  std::mt19937_64 draw(seed);
  std::vector<std::complex<double>> spectrum(count);
  for (std::size_t k = 1; 2 * k < count; ++k) {
    constexpr double kUnit = 0x1p-53;
    const double phase = kTurn * kUnit * static_cast<double>(draw() >> 11);
    const double size = std::sqrt(2.0 * density.at(static_cast<double>(k) * spacing) * spacing);
    spectrum[k] = std::polar(0.5 * size, phase);
    spectrum[count - k] = std::conj(spectrum[k]);
  }
  Eigen::FFT<double> transform;
  transform.SetFlag(Eigen::FFT<double>::Unscaled);
  std::vector<std::complex<double>> sum;
  transform.inv(sum, spectrum);
  std::vector<double> times, values;
  for (std::size_t k = 0; k <= count; ++k) {
    times.push_back(static_cast<double>(k) * step);
    values.push_back(sum[k % count].real());
  }
  return std::make_shared<TimeCourse>(std::move(times), std::move(values), repeats);
}

}  // namespace graze
