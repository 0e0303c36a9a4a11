// All loci of folds, period doublings, tori and grazings of (p, k) orbits in a rectangle of two
// parameters of the scene.
//
// They are started from the special points of branches over either parameter, at values of the
// other spread over its range, and from points where known loci meet others of the wanted kinds. A
// locus that crosses none of these slices and meets no other is missed, so the number of slices is
// reported. Each locus is traced once, to its ends.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/bifurcation/loci/locus_continuations.hpp"
#include "graze/bifurcation/problem/orbit_locus.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"

namespace graze {

struct LociOptions {
  // Options of the slices: the range of the first parameter, period and impacts, the depth of
  // switching at special points, the sources of starts. With its keep_virtual loci go on through
  // virtual solutions, and such points are flagged.
  BranchOptions branches;
  double second_from = 0.0, second_to = 0.0;
  std::vector<OrbitLocusKind> kinds;
  // Values of either parameter at which branches over the other are traced, besides the scene's
  // own.
  int slices = 8;
  // Instead of slices: trace only the locus of this start, and those that meet it.
  std::optional<OrbitLocusStart> start{};
};

struct OrbitLoci {
  std::string first, second;  // names of the parameters
  std::vector<OrbitLocus> loci;
  std::vector<std::string> levels{};  // names of those that were asked for, by OrbitLocus::level
  int slices = 0;                     // branches were sought on
  int traces_cut_short = 0;           // of these branches
  int starts = 0;                     // special points that they offered
  int lost_starts = 0;                // starts from which no locus could be solved for
  int cut_short = 0;                  // loci that could not be followed to an end
  long long shooting_evaluations = 0;
  StopReason stopped = StopReason::kNone;
};

// Throws InputError where the scene has no such parameters or both are the same.
OrbitLoci trace_loci(const Scene& scene, const std::string& first, const std::string& second,
                     const LociOptions& options);

}  // namespace graze
