// The motions of branches and of a sweep as the things of a chart.
#pragma once

#include <vector>

#include "graze/record/study_records.hpp"
#include "graze/report/chart/chart.hpp"
#include "graze/report/chart/detail/motion_observables.hpp"

namespace graze {

// Their numbers, from 0: the rows of the sweep, then the points of all branches, then the special
// points of all.
class MotionNumbers {
 public:
  MotionNumbers(const std::vector<OrbitBranch>& branches, std::size_t rows);

  // `point`: of the branch; of its special points -1 - index.
  int of(std::size_t branch, int point) const {
    return point >= 0 ? points_[branch] + point : special_[branch] - 1 - point;
  }

 private:
  std::vector<int> points_, special_;  // the first of each branch
};

// `swept`: the sweep, or null.
ChartThings motion_things(const BranchRecord& record, const Sweep* swept,
                          const std::vector<MotionObservable>& observables);

}  // namespace graze
