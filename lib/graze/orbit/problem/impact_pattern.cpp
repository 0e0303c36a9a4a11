#include "graze/orbit/problem/impact_pattern.hpp"

#include "graze/base/angle.hpp"

namespace graze {

const Stop& stop_of(const System& system, const ImpactPattern& pattern, std::size_t i) {
  return system.stops[static_cast<std::size_t>(pattern.stops[i])];
}

double flight_time(const System& system, const ImpactPattern& pattern,
                   const std::vector<ImpactPoint>& points, std::size_t i) {
  const bool last = i + 1 == points.size();
  const double turn = last ? kTurn * pattern.period : 0.0;
  // In this order 2 pi p is unrounded for k = 1.
  return (points[last ? 0 : i + 1].theta - points[i].theta + turn) / system.forcing()->frequency;
}

}  // namespace graze
