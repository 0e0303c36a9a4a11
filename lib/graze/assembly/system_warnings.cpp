#include "graze/assembly/detail/system_warnings.hpp"

#include <fmt/format.h>

#include <limits>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/contact/detail/impulse.hpp"
#include "graze/structure/modal_model.hpp"

namespace graze {
namespace {

// Above this, solves with the collocation matrix keep fewer than half of the 16 digits.
constexpr double kIllConditioned = 1e8;

}  // namespace

double collocation_condition(const Scene& scene) {
  return uses_collocation(scene) ? condition_number(modal_model(scene).collocation) : 0.0;
}

std::vector<std::string> system_warnings(const Scene& scene, const System& system) {
  std::vector<std::string> warnings;
  const double condition = collocation_condition(scene);
  if (condition > kIllConditioned)
    warnings.push_back(fmt::format(
        "the collocation points are ill-conditioned: condition number {:.3g}, above {:.0e}; "
        "points spread evenly over the beam (i L/N) have about 2",
        condition, kIllConditioned));
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    if (scene.stops[i].impulse != Impulse::kCollocation) continue;
    const Stop& stop = system.stops[i];
    // The gain grows with r; one that depends on the speed is not known beforehand.
    const double r = stop.restitution().is_constant() ? stop.restitution().at_rest() : 1.0;
    const double gain = worst_energy_gain(stop.row, stop.direction(), r);
    // For N = 1 the collocation law is the momentum law.
    if (gain > 1.0 + 16.0 * std::numeric_limits<double>::epsilon())
      warnings.push_back(fmt::format(
          "the collocation impulse of stop {} is oblique: one impact can multiply the kinetic "
          "energy by up to {:.6g}",
          i + 1, gain));
  }
  return warnings;
}

}  // namespace graze
