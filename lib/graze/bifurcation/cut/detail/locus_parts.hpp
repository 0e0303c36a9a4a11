// A traced locus, divided where its orbits become virtual.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "graze/bifurcation/problem/detail/locus_margins.hpp"
#include "graze/bifurcation/problem/orbit_locus.hpp"

namespace graze {

// A point on a locus, with its margins.
struct LocusPlace {
  OrbitLocusPoint at;
  Vector margins;
  std::string label;                    // of a point of codimension two, or ""
  std::optional<LocusMargin> boundary;  // the margin that vanishes here, beyond which solutions are
                                        // virtual
  std::optional<double> other_angle{};  // as of OrbitLocusSpecial
};

// A locus of one kind as it was traced, including virtual parts.
struct LocusTrace {
  OrbitLocus frame;                // its kind, pattern and ends
  std::vector<LocusPlace> places;  // in order along the locus
};

// The admissible parts, each ended by the grazing beyond which solutions are virtual; with
// `keep_virtual` the whole in one piece, those grazings among its special points.
std::vector<OrbitLocus> locus_parts(const LocusTrace& trace, bool keep_virtual);

// Whether an end of the locus could not be followed.
bool is_cut_short(const OrbitLocus& locus);

}  // namespace graze
