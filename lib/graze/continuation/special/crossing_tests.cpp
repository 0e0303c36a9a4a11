#include "graze/continuation/special/detail/crossing_tests.hpp"

#include <cmath>

namespace graze {
namespace {

// c of the header: factors that differ from zero by more have little effect. Multipliers interact
// over distances of the size of their damping, a few hundredths; this is well above that, and well
// below the usual distances of 1 or 2.
constexpr double kNearCrossing = 0.5;

// Multiplies a test by g of a factor with this squared modulus.
void multiply(CrossingTest& test, double squared_size, double error) {
  test.log_size += 0.5 * std::log(squared_size / (squared_size + kNearCrossing * kNearCrossing));
  test.known = test.known && squared_size > error * error;
}

}  // namespace

CrossingTests crossing_tests(const std::vector<Eigenvalue>& multipliers) {
  CrossingTests tests;
  auto& [flip, fold, torus] = tests;
  for (std::size_t i = 0; i < multipliers.size(); ++i) {
    const Eigenvalue& m = multipliers[i];
    const bool real = m.value.imag() == 0.0;
    multiply(flip, std::norm(1.0 + m.value), m.error);
    multiply(fold, std::norm(1.0 - m.value), m.error);
    if (real && m.value.real() < -1.0) flip.sign = -flip.sign;
    if (real && m.value.real() > 1.0) fold.sign = -fold.sign;
    for (std::size_t j = 0; j < i; ++j) {
      const Eigenvalue& other = multipliers[j];
      const Complex factor = 1.0 - m.value * other.value;
      // Past the doubles' range the factor is far from zero, and g of it 1.
      if (!std::isfinite(std::norm(factor))) continue;
      multiply(torus, std::norm(factor),
               m.error * std::abs(other.value) + other.error * std::abs(m.value));
      // All other factors come in conjugate pairs.
      const bool counts = (real && other.value.imag() == 0.0) || other.value == std::conj(m.value);
      if (counts && factor.real() < 0.0) torus.sign = -torus.sign;
    }
  }
  return tests;
}

}  // namespace graze
