#include <array>

#include "graze/study/accuracy_costs.hpp"
#include "graze/study/processor_time.hpp"
#include "graze/study/step_choice.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// v_c in parts of the speed at the stops.
constexpr std::array<double, 8> kClosures = {3e-2, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
constexpr double kRowSeconds = 0.5;

}  // namespace

std::vector<ClosureCost> closure_costs(const System& system, const State& start,
                                       const AccuracyCostOptions& options) {
  std::vector<ClosureCost> rows;
  const double unit = speed_scale(system, start), fastest = kClosures.front() * unit;
  SimulationOptions run_options;
  run_options.duration = options.longest;
  run_options.stop = options.stop;
  run_options.closure_speed = fastest;
  if (system.stops.empty() || simulate(system, start, run_options).totals.chatters == 0)
    return rows;
  const RunComparison comparison(
      reference_run(system, start, {options.impacts, fastest, options.longest, options.stop}),
      options.impacts, fastest, modal_speed(system, start));
  const double end = comparison.reference().end_time;
  if (comparison.impacts() == 0 || !(end > 0.0)) return rows;
  run_options.duration = end;
  const double period = system.forcing ? system.period() : 1.0;
  for (const double part : kClosures) {
    if (options.stop.requested()) break;
    ClosureCost row;
    row.speed = part * unit;
    run_options.closure_speed = row.speed;
    Simulation run;
    const double seconds =
        least_time([&] { run = simulate(system, start, run_options); }, kRowSeconds, options.stop);
    row.compared = comparison.of(system, start, run_options);
    row.seconds_per_period = seconds * period / end;
    row.impacts_per_period = static_cast<double>(run.totals.impacts) * period / end;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace graze
