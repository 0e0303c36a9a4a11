// Branches of periodic orbits over a parameter of the scene: the shooting equations as a zero
// problem, stability and admissibility of every point, and the grazings that end a branch.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "graze/continuation/branch.hpp"
#include "graze/orbit/finder.hpp"
#include "graze/system/system_family.hpp"

namespace graze {

enum class SpecialKind { kFold, kGrazing };  // LP, GR

struct OrbitBranchPoint {
  double value = 0.0;  // of the parameter
  Orbit orbit;
  int unstable_multipliers = 0;
  double smallest_speed = 0.0;  // m/s
};

struct SpecialPoint {
  SpecialKind kind = SpecialKind::kFold;
  std::string id;  // "LP1"
  OrbitBranchPoint at;
  std::optional<Complex> multiplier;  // the critical one
  // For a grazing: whether an impact speed vanishes there (else an interior approach touches).
  bool by_speed = false;
};

enum class OrbitBranchEnd { kParameterLimit, kClosed, kGrazing, kStepLimit, kNotConverged };

struct OrbitBranch {
  int id = 0;         // from 1
  int component = 0;  // connected set of solutions it is part of, from 1
  std::vector<OrbitBranchPoint> points;
  std::vector<SpecialPoint> special;  // in order along the branch
  std::array<OrbitBranchEnd, 2> ends{OrbitBranchEnd::kNotConverged, OrbitBranchEnd::kNotConverged};
};

struct BranchOptions {
  int period = 1;  // p; k = 1
  double from = 0.0, to = 0.0;
  double max_step = 0.0;  // of the parameter; 0: a fiftieth of the range
  // Start values across the range, besides the scene's own; with any, also the starts that a survey
  // of the closed form offers.
  int start_values = 32;
  bool keep_virtual = false;
  FinderOptions finder;  // starts, at the scene's own value
  StopSignal stop;
  std::function<void(double fraction)> progress;
};

struct OrbitBranches {
  std::string parameter;
  std::vector<OrbitBranch> branches;
  std::vector<std::string> notes;      // sentences
  long long shooting_evaluations = 0;  // of the shooting equations, all points together
  long long rejected_steps = 0;
  int starts = 0;           // solutions offered as starts
  int surveyed_values = 0;  // at which the closed form was sampled for further starts
  int traced = 0;           // traces begun, one for each start that no earlier one had passed
  int cut_short = 0;        // traces that could not be followed to an end
  StopReason stopped = StopReason::kNone;
};

// Traces every branch of (p, 1) orbits that the starts lead to. Without `keep_virtual` a branch
// ends at the grazing where its solutions stop being orbits of the system.
OrbitBranches trace_orbits(const SystemFamily& family, const BranchOptions& options);

// The shooting equations over the family's parameter, as continuation takes them.
ZeroProblem orbit_problem(const SystemFamily& family, const ShootingProblem& shooting);

}  // namespace graze
