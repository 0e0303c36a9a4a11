// Where two models agree: the difference of the motions of two scenes over a plane of numbers that
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
  std::string message;  // a sentence, or empty
};

// Shares are of the cells; pieces are named "cell i".
struct ComparisonMapOptions : CompareOptions, Plane, SharedWork<ComparedCell> {};

struct ComparisonMap {
  ComparisonMapOptions options;
  std::vector<ComparedCell> cells;  // as the plane has them
  StopReason stopped = StopReason::kNone;
};

// Every cell consists of two runs of its own, so the map depends on its values alone. A cell whose
// values a scene does not allow says so. Requires of both scenes the same as compared_motion;
// throws InputError as require_plane, and where the scenes differ only in the numbers of the plane.
ComparisonMap compare_over(const Scene& one, const Scene& other,
                           const ComparisonMapOptions& options);

}  // namespace graze
