#include <fmt/format.h>

#include <array>

#include "graze/study/cost/accuracy_costs.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "graze/study/cost/timed_run.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// v_c relative to the speed at the stops.
constexpr std::array<double, 8> kClosures = {3e-2, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
// Impacts beyond the chatter that are compared: few, since each magnifies every error.
constexpr std::size_t kImpactsAfter = 4;

// Number of impacts faster than the closure speed before the first chatter is summed; nullopt when
// none is.
std::optional<std::size_t> impacts_before_chatter(const System& system, const State& start,
                                                  const SimulationOptions& options) {
  std::size_t impacts = 0;
  std::optional<std::size_t> found;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    if (event.kind == EventKind::kImpact && event.speed > *options.closure_speed) ++impacts;
    if (event.kind == EventKind::kChatter && !found) found = impacts;
  };
  simulate(system, start, options, listeners);
  return found;
}

}  // namespace

ClosureCosts closure_costs(const System& system, const State& start,
                           const AccuracyCostOptions& options) {
  ClosureCosts costs;
  if (system.has_compliant_stop()) {
    costs.message = "not measured where a stop is compliant";
    return costs;
  }
  const double unit = speed_scale(system, start), fastest = kClosures.front() * unit;
  SimulationOptions run_options;
  run_options.duration = options.longest;
  run_options.max_impacts = options.max_impacts;
  run_options.stop = options.stop;
  run_options.closure_speed = fastest;
  const std::optional<std::size_t> before = impacts_before_chatter(system, start, run_options);
  if (!before) return costs;
  // The error of the summed tail shows in the impacts after it.
  const std::size_t impacts = *before + kImpactsAfter;
  const RunComparison comparison(
      reference_run(system, start, {impacts, fastest, options.longest, options.stop}), impacts,
      fastest, modal_speed(system, start));
  const double end = comparison.reference().end_time;
  if (comparison.impacts() == 0 || !(end > 0.0)) return costs;
  run_options.duration = end;
  for (const double part : kClosures) {
    if (options.stop.requested()) break;
    ClosureCost row;
    row.speed = part * unit;
    run_options.closure_speed = row.speed;
    const TimedRun run = timed_run(system, start, run_options);
    row.compared = comparison.of(system, start, run_options);
    row.seconds_per_period = run.seconds_per_period;
    row.impacts_per_period = run.impacts_per_period;
    costs.rows.push_back(row);
  }
  if (!costs.rows.empty() && !costs.rows.back().compared.impacts_agree)
    costs.message = fmt::format(
        "rounding alone changes some of the {} impacts before the first chatter and after it, so "
        "that the error of the closure speed is not known",
        comparison.impacts());
  return costs;
}

}  // namespace graze
