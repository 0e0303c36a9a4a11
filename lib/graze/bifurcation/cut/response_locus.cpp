#include "graze/bifurcation/cut/detail/response_locus.hpp"

#include <array>

#include "graze/bifurcation/cut/detail/response_boundaries.hpp"

namespace graze {

std::optional<Orbit> ResponseLocus::orbit(const LocusSite& at) const {
  const System* system = equations_.system_at(std::array{at.first, at.second});
  const std::optional<Response> response = system ? response_of(*system) : std::nullopt;
  return response ? std::optional(response_orbit(*system, *response)) : std::nullopt;
}

std::optional<LocusPlace> ResponseLocus::place(const LocusSite& at,
                                               std::optional<LocusMargin> zero) const {
  const std::optional<Orbit> found = orbit(at);
  if (!found) return {};
  return LocusPlace{{at.first, at.second, 0.0, {}, found->admissible, {}, found->section},
                    *margins(at),
                    "",
                    zero};
}

std::optional<Vector> ResponseLocus::margins(const LocusSite& at) const {
  const std::optional<Orbit> found = orbit(at);
  if (!found) return {};
  Vector margins = Vector::Ones(kLocusMargins);
  margins[static_cast<Eigen::Index>(LocusMargin::kClearance)] = found->clearance.value_or(1.0);
  return margins;
}

}  // namespace graze
