// Quantities of motions that pictures and pages can show over a parameter, or over one another:
// numbers of the dots of a sweep and of the points of branches.
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
  // Whether a motion has one value, or one for each of its impacts or forcing periods.
  bool is_of_motion = false;
  bool from_zero = false;
  std::vector<DiagramCurve> curves = {};  // one a branch, or none
  // Values of a row's dots; empty: dots do not have it.
  std::function<std::vector<double>(const SweepRow&)> heights = {};
  std::optional<double> reference = {};  // a line across
  double most = 1e300;                   // of the axis
  std::optional<double> turn = {};       // period of an angle, in its unit
};

// All observables of the records, the one of the picture first. `swept`: the sweep, or null. They
// refer to the records.
std::vector<MotionObservable> motion_observables(const BranchRecord& record, const Sweep* swept);

// The same for a stroboscopic diagram: displacements and velocities at the stops instead of speeds.
std::vector<MotionObservable> motion_observables(const DiagramRecord& record);

// The range of an axis of Lyapunov exponents: zero, and the largest exponents as far down as needed
// to distinguish order from chaos. Superstable orbits reach down without bound, and so do the other
// exponents.
AxisRange exponent_range(const Sweep& swept);

// Whether a row's motion is shown.
bool has_dots(const SweepRow& row);

}  // namespace graze
