// Loci that pass a special point of another locus: they are started at its points of codimension
// two, so that a locus which no slice meets is found where it meets another.
#pragma once

#include <array>
#include <vector>

#include "graze/bifurcation/problem/grazing_orbit.hpp"
#include "graze/bifurcation/problem/orbit_locus.hpp"

namespace graze {

// A special point of orbits, at or near a locus.
struct OrbitLocusStart {
  OrbitLocusKind kind = OrbitLocusKind::kFold;
  GrazingOrbit orbit;  // in its canonical order; on GR from the grazing contact on
  double first = 0.0, second = 0.0;
  Complex multiplier = 1.0;         // of NS: one of the pair
  std::optional<Orbit> followed{};  // in place of `orbit`: one that is followed
  std::size_t level = 0;            // of UZ and EX: which of the levels

  std::array<double, 2> place() const { return {first, second}; }
  bool meets_stops() const { return followed || !orbit.impacts.empty(); }
};

// An orbit at a special point as a start of its locus. For a locus of grazing it is relabelled to
// start with its touch, an impact whose speed vanishes (`by_speed`) or the nearest approach;
// returns nullopt when there is no approach. `system`: at these values.
struct LocusStartPlace {
  double first = 0.0, second = 0.0;
  Complex multiplier = 1.0;  // the critical one
};
std::optional<OrbitLocusStart> locus_start(const System& system, OrbitLocusKind kind,
                                           const GrazingOrbit& orbit, bool by_speed,
                                           const LocusStartPlace& place);

// `system`: at the special point; `speed_unit`, m/s, of the forced motion.
std::vector<OrbitLocusStart> continuations_from(const System& system, const OrbitLocus& locus,
                                                const OrbitLocusSpecial& special,
                                                double speed_unit);

}  // namespace graze
