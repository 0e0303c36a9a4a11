// Where two choices agree: the difference of the motions of two scenes over a plane of numbers that
// both have.
#pragma once

#include <string>
#include <vector>

#include "graze/study/compare/compared_motion.hpp"
#include "graze/study/plane/plane.hpp"
#include "graze/study/sweep/shared_work.hpp"

namespace graze {

struct ComparedCell {
  bool is_known = false;  // false: it was not run
  AttractorClass one, other;
  MotionDifference difference;
  std::string message;  // a sentence where there is something to say
};

// The share is of the cells, the memory too, "cell i".
struct ComparisonMapOptions : CompareOptions, Plane, SharedWork<ComparedCell> {};

struct ComparisonMap {
  ComparisonMapOptions options;
  std::vector<ComparedCell> cells;  // as the plane has them
  StopReason stopped = StopReason::kNone;
};

// Every cell is two runs of its own, so the map depends on nothing but its values. Cells whose
// values a scene does not allow are such that say so. Requires of both scenes what compared_motion
// does; throws InputError as require_plane,
// and where the plane leaves nothing that tells the scenes apart.
ComparisonMap compare_over(const Scene& one, const Scene& other,
                           const ComparisonMapOptions& options);

}  // namespace graze
