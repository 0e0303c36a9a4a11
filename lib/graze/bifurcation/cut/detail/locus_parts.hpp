// A traced locus, divided where its orbits stop being orbits of the system.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "graze/bifurcation/problem/detail/locus_margins.hpp"
#include "graze/bifurcation/problem/orbit_locus.hpp"

namespace graze {

// A point met along a locus, with what has to stay positive there.
struct LocusPlace {
  OrbitLocusPoint at;
  Vector margins;
  std::string label;                    // of a point of codimension two, or ""
  std::optional<LocusMargin> boundary;  // what vanishes here and forbids the orbit beyond
  std::optional<double> other_angle{};  // as of OrbitLocusSpecial
};

// A locus of one kind as it was traced, virtual parts and all.
struct LocusTrace {
  OrbitLocus frame;                // its kind, pattern and ends
  std::vector<LocusPlace> places;  // in order along the locus
};

// The parts whose orbits are orbits of the system, each ended by the grazing beyond which they are
// not; with `keep_virtual` the whole in one piece, those grazings among its special points.
std::vector<OrbitLocus> locus_parts(const LocusTrace& trace, bool keep_virtual);

// Whether one could not be followed to an end.
bool is_cut_short(const OrbitLocus& locus);

}  // namespace graze
