// Options of branches of orbits (orbit_branches.hpp).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/bifurcation/problem/orbit_level.hpp"
#include "graze/bifurcation/problem/special_orbit.hpp"
#include "graze/orbit/search/finder_values.hpp"
#include "graze/system/system.hpp"

namespace graze {

// A state at the start of a forcing period, of a motion that has settled at a value of the
// parameter, or of an orbit of so many forcing periods.
struct SettledStart {
  double value = 0.0;
  State state;
  int period = 0;  // p of the orbit; 0: not known
};

struct BranchOptions {
  int period = 1;   // p
  int impacts = 1;  // k, on all stops together; 0: none are sought
  // Also the response that meets no stop, where it is clear of them (period 1).
  bool response = false;
  double from = 0.0, to = 0.0;
  double max_step = 0.0;  // of the parameter; 0: a fiftieth of the range
  // Start values across the range, besides the scene's own; if there are any, also the starts of a
  // survey of the closed form.
  int start_values = 32;
  bool keep_virtual = false;
  // Also orbits that stick, of any number of impacts, with period p; searched for by simulation.
  bool sticking = true;
  // Number of successive special points at which to switch: onto doubled orbits (PD), crossing
  // branches (BP), other impact sequences (GR), and for orbits that stick onto orbits with an
  // impact (GR) or a stuck phase (CH) more or less, or those of the first windows beyond CH; 0:
  // none.
  int follow_depth = 0;
  std::vector<OrbitLevel> levels{};  // marked along the branches: UZ and EX
  bool normal_forms = false;         // of LP, PD and NS; along loci where they vanish
  // Also branches through the orbits of these motions, whatever their period and impacts.
  std::vector<SettledStart> settled{};
  // Instead of all starts: only the branch through it, and those that `follow_depth` leads to.
  std::optional<BranchStart> start{};
  FinderOptions finder{};  // starts, at the scene's own value
  StopSignal stop{};
  std::function<void(double fraction)> progress{};
};

}  // namespace graze
