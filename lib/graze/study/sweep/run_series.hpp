// One run from the scene's start at each of several values of a parameter, for a given time: its
// impacts, and what its probes saw. For motions that no forcing repeats, where nothing settles.
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
  // Of the probes, in their order: largest size over the run and value at its end, SI. Between
  // samples, 20 to the quickest oscillation, extremes lie on quartics.
  std::vector<double> peaks, ends;
};

// The share is of the values, the memory of the runs, "row i".
struct RunSeriesOptions : SharedWork<ValueRun> {
  std::string parameter;  // or a number of the start, "initial.rate"
  std::vector<double> values;
  double duration = 0.0;                // s
  std::optional<double> closure_speed;  // m/s; absent: the default at every value
  long long max_impacts = kDefaultImpactBudget;
  StopSignal stop;
};

// In the order of the values; where a stop was asked for before all were done, those that were, and
// of a share its own. Throws InputError where the scene does not allow a value.
std::vector<ValueRun> run_series(const Scene& scene, const RunSeriesOptions& options);

}  // namespace graze
