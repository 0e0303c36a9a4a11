// The cost of accuracy apart from the flow: the number of modes, the speed below which a chatter is
// summed, Newton's steps towards an orbit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/scene/scene.hpp"
#include "graze/study/cost/run_comparison.hpp"

namespace graze {

struct AccuracyCostOptions {
  double longest = 0.0;  // s of motion, at most
  // m/s, for the runs with different numbers of modes; absent: each has its own default.
  std::optional<double> closure_speed{};
  long long max_impacts = kDefaultImpactBudget;  // of every run
  StopSignal stop{};
};

// A beam with N modes compared with one with kMostModesCompared; on a hub, where steps follow the
// fastest mode and time goes with N^3 or more, with kMostModesOnHub.
struct ModeCost {
  int modes = 0;
  std::optional<double> error;      // of the first impact time, s; absent where there is no impact
  double seconds_per_period = 0.0;  // of computing time, per forcing period (per second without)
  double evaluations_per_period = 0.0;
};
inline constexpr int kMostModesCompared = 64, kMostModesOnHub = 16;

// Empty where the number of modes is fixed: a structure given by its modes, lists with one entry
// per mode. Numbers that the scene does not allow or that could not be followed are left out.
std::vector<ModeCost> mode_costs(const Scene& scene, const AccuracyCostOptions& options);

// The exact flow, with chatters summed below v_c, compared with the motion in 50 digits that
// follows them down to 1e-16 of the speed of the motion.
struct ClosureCost {
  double speed = 0.0;  // v_c, m/s
  // For impacts faster than the largest v_c of the list, up to the fourth after the first chatter.
  RunError compared;
  double seconds_per_period = 0.0;
  double impacts_per_period = 0.0;  // followed one by one
};

struct ClosureCosts {
  std::vector<ClosureCost> rows;  // none where no chatter is summed
  std::string message;            // why errors could not be compared
};
ClosureCosts closure_costs(const System& system, const State& start,
                           const AccuracyCostOptions& options);

// Newton's method on the shooting equations of an orbit of the scene, step by step.
struct CorrectorCost {
  // Started from the orbit at a forcing frequency lower by kNeighbour: as it is, or moved along the
  // tangent of the branch, as a continuation starts.
  bool predicted = false;
  int steps = 0;
  double residual = 0.0;  // largest entry of the scaled equations: the tolerance that is met
  double error = 0.0;     // largest of an impact time, s, against the converged solution
  double seconds = 0.0;   // of computing time, all steps together
};
inline constexpr double kNeighbour = 0.001;

struct CorrectorCosts {
  std::string orbit;    // "orbit (1, 1)"
  std::string message;  // why there is none
  std::vector<CorrectorCost> rows;
};

// For the first orbit with one impact a period, on its branch over the forcing frequency.
CorrectorCosts corrector_costs(const Scene& scene, const AccuracyCostOptions& options);

}  // namespace graze
