// What branches of orbits are asked for with, and what comes of it; orbit_branches.hpp traces them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "graze/bifurcation/component_search.hpp"
#include "graze/bifurcation/orbit_branch.hpp"
#include "graze/bifurcation/special_orbit.hpp"
#include "graze/orbit/finder.hpp"

namespace graze {

struct BranchOptions {
  int period = 1;   // p
  int impacts = 1;  // k, on all stops together
  double from = 0.0, to = 0.0;
  double max_step = 0.0;  // of the parameter; 0: a fiftieth of the range
  // Start values across the range, besides the scene's own; with any, also the starts that a survey
  // of the closed form offers.
  int start_values = 32;
  bool keep_virtual = false;
  // Orbits that stick too, whatever their number of impacts, with period p; sought by simulation.
  bool sticking = true;
  // How many special points in a row are switched at, onto doubled orbits (PD), crossing branches
  // (BP), rewritten impact sequences (GR), and where they stick onto orbits with an impact (GR) or
  // a stuck phase (CH) more or less, or those of the first windows beyond CH; 0: none.
  int follow_depth = 0;
  // In place of all starts: only the branch through it, and those that `follow_depth` leads to.
  std::optional<BranchStart> start{};
  FinderOptions finder{};  // starts, at the scene's own value
  StopSignal stop{};
  std::function<void(double fraction)> progress{};
};

struct OrbitBranches {
  std::string parameter;
  std::vector<OrbitBranch> branches;
  // Units of the unknowns in the solutions at special points, and the range of the parameter that
  // their tangents are given in.
  MotionScale scale;
  double range = 1.0;
  std::vector<std::string> notes;      // sentences
  long long shooting_evaluations = 0;  // of the shooting equations, all points together
  long long rejected_steps = 0;
  int starts = 0;          // solutions offered as starts
  int virtual_starts = 0;  // those that solve the equations and are no orbits, so are not traced
  ComponentSearch sought;  // how the components of (p, 1) solutions were
  int traced = 0;          // traces begun, one for each start that no earlier one had passed
  int cut_short = 0;       // traces that could not be followed to an end
  int meetings = 0;        // branches ended by impacts that meet
  int switched = 0;        // special points switched at
  int left_open = 0;       // special points at the stated depth that were not switched at
  StopReason stopped = StopReason::kNone;
};

}  // namespace graze
