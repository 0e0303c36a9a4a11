// The quantities that have to stay positive along a locus for its orbits to be admissible.
#pragma once

#include <optional>
#include <vector>

#include "graze/orbit/problem/orbit.hpp"

namespace graze {

// Where the first of these vanishes along a locus its orbits end.
enum class LocusMargin {
  kClearance,  // of the nearest approach, m
  kSpeed,      // of the slowest impact, except the one that touches, m/s
  kFlight,     // the shortest one, s
  kPull,       // of the forces right after an impact that leaves its stop at rest (r = 0), m/s^2
  kBend        // of the gap where it touches, m/s^2
};
inline constexpr Eigen::Index kLocusMargins = 5;

// The nearest approach of a touching orbit to a stop besides its grazing contact and its impacts.
struct ApproachBeside {
  std::size_t impact = 0;  // the impact before it; where no impact has a speed, the grazing contact
  int stop = 0;            // index from 0
  State start;             // of the flight in which it is
  double theta = 0.0;      // phase there, rad
  double after = 0.0;      // s later
  double gap = 0.0;        // m
};
// The smallest interior minimum of any stop's gap except the grazing contact, which flights pass
// like any other approach. Returns nullopt when there is none.
std::optional<ApproachBeside> approach_beside(const System& system, const ImpactPattern& pattern,
                                              const std::vector<ImpactPoint>& impacts,
                                              std::size_t grazing);

// Approach speeds of all impacts, m/s.
Vector approach_speeds(const System& system, const ImpactPattern& pattern,
                       const std::vector<ImpactPoint>& impacts);

// Values indexed by LocusMargin; a margin that does not apply is 1. `grazing`: the impact at zero
// speed, on a locus of grazing orbits.
Vector locus_margins(const System& system, const ImpactPattern& pattern,
                     const std::vector<ImpactPoint>& impacts, std::optional<std::size_t> grazing);

// Whether all are positive, speeds beyond their error.
bool is_admissible(const System& system, const Vector& margins);
// Whether all but one are not negative, within their errors: where that one vanishes the orbits
// end.
bool are_others_positive(const System& system, const Vector& margins, LocusMargin but_for);

}  // namespace graze
