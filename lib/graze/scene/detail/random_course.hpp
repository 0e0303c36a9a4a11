// Random loads by their spectral density.
#pragma once

#include <memory>
#include <vector>

#include "graze/base/time_course.hpp"

namespace graze {

// A one-sided density over frequencies, Hz, rising, joined by straight lines; zero beside them.
struct SpectralDensity {
  std::vector<double> frequencies, values;  // Hz, unit^2/Hz
  double at(double frequency) const;
};

// Instants `step` seconds apart over `duration`, of the sum of sqrt(2 S(f) df) cos(2 pi f t + psi) over
// the multiples f of df = 1/duration up to half the rate of the instants, with independent phases psi
// that `seed` draws, the same on every machine (M. Shinozuka, C.-M. Jan, J. Sound Vib. 25 (1972)
// 111-128). The duration is rounded to a whole number of steps.
std::shared_ptr<TimeCourse> drawn_course(const SpectralDensity& density, double duration, double step,
                                         unsigned seed, bool repeats = false);

}  // namespace graze
