// One run from the scene's start at each of several values of a parameter, for a given time: its
// impacts, and the extremes of its probes. For motions without periodic forcing, which do not
// settle.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/base/defaults.hpp"
#include "graze/base/stop_signal.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/scene/scene.hpp"
#include "graze/study/run_impact.hpp"
#include "graze/study/sweep/shared_work.hpp"

namespace graze {

struct ValueRun {
  double value = 0.0;  // of the parameter, SI
  RunOutcome outcome = RunOutcome::kReachedEnd;
  std::string message;             // a sentence unless the end was reached
  std::vector<RunImpact> impacts;  // and contacts
  // For the probes, in their order: largest size over the run and value at its end, SI. Between
  // samples, 20 to the fastest oscillation, extremes are those of quartics.
  std::vector<double> peaks, ends;
};

// Shares are of the values; pieces, one for each run, are named "row i".
struct RunSeriesOptions : SharedWork<ValueRun> {
  std::string parameter;  // or a number of the start, "initial.rate"
  std::vector<double> values;
  double duration = 0.0;                // s
  std::optional<double> closure_speed;  // m/s; absent: the default at every value
  long long max_impacts = kDefaultImpactBudget;
  StopSignal stop;
};

// In the order of the values; only the finished ones when it was stopped, and only those of its
// share. Throws InputError where the scene does not allow a value.
std::vector<ValueRun> run_series(const Scene& scene, const RunSeriesOptions& options);

}  // namespace graze
