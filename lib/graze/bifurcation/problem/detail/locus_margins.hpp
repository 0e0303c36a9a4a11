// What has to stay positive along a locus for its orbits to be orbits of the system.
#pragma once

#include <optional>
#include <vector>

#include "graze/orbit/problem/orbit.hpp"

namespace graze {

// Where the first of these vanishes along a locus its orbits cease to be any.
enum class LocusMargin {
  kClearance,  // of the nearest approach, m
  kSpeed,      // of the slowest impact but for the one that touches, m/s
  kFlight,     // the shortest one, s
  kPull,       // of the forces right after an impact that leaves its stop at rest (r = 0), m/s^2
  kBend        // of the gap where it touches, m/s^2
};
inline constexpr Eigen::Index kLocusMargins = 5;

// Where a touching orbit comes nearest to a stop besides its grazing contact and its impacts.
struct ApproachBeside {
  std::size_t impact = 0;  // it comes after; where no impact has a speed the grazing contact
  int stop = 0;            // index from 0
  State start;             // of the flight in which it is
  double theta = 0.0;      // phase there, rad
  double after = 0.0;      // s later
  double gap = 0.0;        // m
};
// The smallest interior minimum of any stop's gap but for the grazing contact, which flights pass
// as they pass any other approach. Nothing where there is none.
std::optional<ApproachBeside> approach_beside(const System& system, const ImpactPattern& pattern,
                                              const std::vector<ImpactPoint>& impacts,
                                              std::size_t grazing);

// Of every impact, m/s.
Vector approach_speeds(const System& system, const ImpactPattern& pattern,
                       const std::vector<ImpactPoint>& impacts);

// Indexed by LocusMargin; a margin that does not apply is 1. `grazing`: the impact at zero speed,
// on a locus of grazing orbits.
Vector locus_margins(const System& system, const ImpactPattern& pattern,
                     const std::vector<ImpactPoint>& impacts, std::optional<std::size_t> grazing);

// Whether all are positive, speeds above what is known of them.
bool is_admissible(const System& system, const Vector& margins);
// Whether all but one are not negative, within what is known of them: where that one vanishes the
// orbits cease to be any.
bool are_others_positive(const System& system, const Vector& margins, LocusMargin but_for);

}  // namespace graze
