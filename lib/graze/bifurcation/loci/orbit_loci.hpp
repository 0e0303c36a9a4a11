// All loci of folds, period doublings, tori and grazings of (p, k) orbits in a rectangle of two
// parameters of the scene.
//
// They are started from the special points of branches over either parameter, at values of the
// other spread over its range, and from where the loci found so far meet others of the kinds asked
// for. A locus that crosses none of these slices and meets no other is not found, so their number
// is stated. Each locus is traced once, to its ends.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/bifurcation/loci/locus_continuations.hpp"
#include "graze/bifurcation/problem/orbit_locus.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"

namespace graze {

struct LociOptions {
  // Of the slices: the range of the first parameter, period and impacts, how far special points are
  // switched at, where starts come from. With its keep_virtual loci go on through solutions that
  // are no orbits of the system, and such points are flagged.
  BranchOptions branches;
  double second_from = 0.0, second_to = 0.0;
  std::vector<OrbitLocusKind> kinds;
  // Values of either parameter at which branches over the other are traced, besides the scene's
  // own.
  int slices = 8;
  // In place of slices: only its locus, and those that meet it.
  std::optional<OrbitLocusStart> start{};
};

struct OrbitLoci {
  std::string first, second;  // names of the parameters
  std::vector<OrbitLocus> loci;
  int slices = 0;            // branches were sought on
  int traces_cut_short = 0;  // of these branches
  int starts = 0;            // special points that they offered
  int lost_starts = 0;       // that led to no locus that could be solved for
  int cut_short = 0;         // loci that could not be followed to an end
  long long shooting_evaluations = 0;
  StopReason stopped = StopReason::kNone;
};

// Throws InputError where the scene has no such parameters or both are one.
OrbitLoci trace_loci(const Scene& scene, const std::string& first, const std::string& second,
                     const LociOptions& options);

}  // namespace graze
