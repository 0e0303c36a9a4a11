#include "graze/system/system.hpp"

#include <cmath>

namespace graze {

ComplexVector Harmonic::force() const {
  return cosine.cast<Complex>() - Complex(0.0, 1.0) * sine.cast<Complex>();
}

Vector HarmonicForcing::at(double theta) const {
  Vector sum = amplitude * std::cos(theta);
  for (const Harmonic& one : harmonics)
    sum += one.cosine * std::cos(one.order * theta) + one.sine * std::sin(one.order * theta);
  return sum;
}

Vector HarmonicForcing::rate_at(double theta) const {
  Vector sum = -amplitude * std::sin(theta);
  for (const Harmonic& one : harmonics)
    sum += one.order *
           (one.sine * std::cos(one.order * theta) - one.cosine * std::sin(one.order * theta));
  return sum;
}

Vector HarmonicForcing::size() const {
  Vector sum = amplitude.cwiseAbs();
  for (const Harmonic& one : harmonics) sum += one.force().cwiseAbs();
  return sum;
}

std::optional<Vector> modal_forces(const System& system) {
  const HarmonicForcing* forcing = system.forcing();
  if (!forcing) return {};
  return forcing->harmonics.empty() ? forcing->amplitude : forcing->size();
}

}  // namespace graze
