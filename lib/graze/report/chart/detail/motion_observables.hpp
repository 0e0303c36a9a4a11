// What pictures and pages can show of motions over a parameter, or over one another: numbers of the
// dots of a sweep and of the points of branches.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "graze/record/study_records.hpp"
#include "graze/report/chart/axis.hpp"

namespace graze {

struct MotionObservable {
  std::string key, name, unit;  // SI
  // Whether a motion has one value, else one for each of its impacts or forcing periods.
  bool is_of_motion = false;
  bool from_zero = false;
  std::vector<DiagramCurve> curves = {};  // one a branch, or none
  // Of a row's dots; none: dots do not have it.
  std::function<std::vector<double>(const SweepRow&)> heights = {};
  std::optional<double> reference = {};  // a line across
  double most = 1e300;                   // of the axis
  std::optional<double> turn = {};       // of an angle, after which it is the same
};

// All that the records hold, the one that a picture shows first. `swept`: the sweep, or none. They
// refer to the records.
std::vector<MotionObservable> motion_observables(const BranchRecord& record, const Sweep* swept);

// The same of a stroboscopic diagram: displacements and velocities at the stops in place of speeds.
std::vector<MotionObservable> motion_observables(const DiagramRecord& record);

// What an axis of Lyapunov exponents shows: zero, and the largest ones as far down as tells order
// from chaos. Superstable orbits reach down without bound, and so do the other exponents.
AxisRange exponent_range(const Sweep& swept);

// Whether a row's motion is shown.
bool has_dots(const SweepRow& row);

}  // namespace graze
