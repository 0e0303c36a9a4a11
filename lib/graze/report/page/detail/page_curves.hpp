// Branches as a page draws them over any two of their numbers: the points that each line goes
// through, and the numbers of these.
#pragma once

#include <vector>

#include "graze/record/records.hpp"
#include "graze/report/chart/detail/motion_observables.hpp"
#include "graze/report/json/detail/json_value.hpp"

namespace graze {

// By layout: "motion" for all numbers that a motion has one of, and the key of every other number.
// A line has its branch and its kind (LineKind), the points of the branch that it goes through
// (special points of the page: -1 - index) and, but for "motion", which of a point's values each
// node is.
Json page_lines(const BranchRecord& record, const std::vector<MotionObservable>& observables);

// By key, a list of the branches: the values of all points one after the other, SI, and but for
// those that a motion has one of, where the values of each point begin.
Json page_values(const std::vector<MotionObservable>& observables);

}  // namespace graze
