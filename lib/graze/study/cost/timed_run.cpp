#include "graze/study/cost/timed_run.hpp"

#include "graze/study/processor_time.hpp"

namespace graze {

TimedRun timed_run(const System& system, const State& start, const SimulationOptions& options,
                   double enough) {
  TimedRun timed;
  timed.seconds =
      least_time([&] { timed.run = simulate(system, start, options); }, enough, options.stop);
  if (!(timed.run.end_time > 0.0)) return timed;
  const double periods = timed.run.end_time / (system.repeats() ? system.period() : 1.0);
  timed.seconds_per_period = timed.seconds / periods;
  timed.evaluations_per_period = static_cast<double>(timed.run.evaluations) / periods;
  timed.impacts_per_period = static_cast<double>(timed.run.totals.impacts) / periods;
  return timed;
}

}  // namespace graze
