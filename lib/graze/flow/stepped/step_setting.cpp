#include "graze/flow/stepped/step_setting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/system/detail/hub_state.hpp"

namespace graze {
namespace {

// |z| up to which |R(z)| <= 1: along the imaginary axis, and the least along any ray to the left of
// it by more than 10 degrees (damping ratio 0.17). The rays in between reach further than the axis.
// From the polynomials (for fehlberg78 from its tableau) in 30 digits.
struct StableRadius {
  double oscillating = 0.0, damped = 0.0;
};

StableRadius stable_radius(StepMethod method) {
  switch (method) {
    case StepMethod::kRk4:
      return {2.8284271247461901, 2.6155};  // 2 sqrt 2
    case StepMethod::kDopri5:
      return {0.9971890086325301, 2.93};
    case StepMethod::kFehlberg78:
      return {2.3651576140579800, 4.26};
  }
  return {};
}

constexpr double kLightDamping = 0.17364817766693033;  // sin 10 degrees

}  // namespace

double longest_stable_step(const System& system, StepMethod method) {
  const StableRadius radius = stable_radius(method);
  const Vector decay = decay_rates(system);
  double longest = std::numeric_limits<double>::infinity();
  for (Eigen::Index j = 0; j < system.omega.size(); ++j) {
    const double omega = system.omega[j], delta = decay[j];
    // The quicker of the two rates, |l|.
    const double rate =
        delta > omega ? delta + std::sqrt((delta - omega) * (delta + omega)) : omega;
    const bool light = delta <= kLightDamping * omega;
    const double reach = light ? radius.oscillating : std::min(radius.oscillating, radius.damped);
    if (rate > 0.0) longest = std::min(longest, reach / rate);
  }
  return longest;
}

}  // namespace graze
