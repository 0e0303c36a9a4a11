// Branches of orbits over a parameter, and how they were found; orbit_branches.hpp traces them.
#pragma once

#include <string>
#include <vector>

#include "graze/bifurcation/bounds/component_search.hpp"
#include "graze/bifurcation/problem/branch_options.hpp"
#include "graze/bifurcation/problem/orbit_branch.hpp"
#include "graze/system/scale.hpp"

namespace graze {

struct OrbitBranches {
  std::string parameter;
  std::vector<OrbitBranch> branches;
  std::vector<std::string> levels{};  // names of those that were marked, by SpecialPoint::level
  bool has_normal_forms = false;      // those of LP, PD and NS were asked for
  // Units of the unknowns in the solutions at special points, and the range of the parameter in
  // which their tangents are given.
  MotionScale scale;
  double range = 1.0;
  std::vector<std::string> notes;      // sentences: what is missing or wrong, what the motion does
  std::vector<std::string> details;    // sentences about the numerics, for experts
  long long shooting_evaluations = 0;  // of the shooting equations, all points together
  long long rejected_steps = 0;
  int starts = 0;          // solutions offered as starts
  int virtual_starts = 0;  // starts that are virtual solutions, which are not traced
  ComponentSearch sought;  // how the components of (p, 1) solutions were searched for
  int traced = 0;          // number of traces, one for each start not on an earlier branch
  int cut_short = 0;       // traces that could not be followed to an end
  int cut_settled = 0;     // those of them from motions that have settled
  int meetings = 0;        // branches ended by impacts that meet
  int switched = 0;        // special points switched at
  int left_open = 0;       // special points at the stated depth that were not switched at
  StopReason stopped = StopReason::kNone;
};

}  // namespace graze
