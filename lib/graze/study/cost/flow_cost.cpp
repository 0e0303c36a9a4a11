#include "graze/study/cost/flow_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "graze/motion/simulation.hpp"
#include "graze/study/cost/detail/stepped_reference.hpp"
#include "graze/study/cost/step_choice.hpp"

namespace graze {
namespace {

// From one rung of a ladder to the next a step is shorter by the first factor, a tolerance smaller
// by the second.
constexpr double kStepRatio = 4.0, kToleranceRatio = 100.0;
constexpr double kFirstTolerance = 1e-2, kLastTolerance = 1e-14;
constexpr int kMostRungs = 14;

ReferenceRun reference_of(const System& system, const State& start,
                          const ReferenceOptions& options) {
  return is_followed_by_steps(system) ? stepped_reference(system, start, options)
                                      : reference_run(system, start, options);
}

class CostTable {
 public:
  CostTable(const System& system, const State& start, const FlowCostOptions& options)
      : system_(system),
        start_(start),
        options_(options),
        comparison_(
            reference_of(system, start,
                         {options.impacts, options.closure_speed, options.longest, options.stop}),
            options.impacts, options.closure_speed, options.speed) {
    const ReferenceRun& reference = comparison_.reference();
    costs_.impacts = comparison_.impacts();
    costs_.end_time = reference.end_time;
    costs_.forced = system.forcing() != nullptr;
    costs_.compliant = system.has_compliant_stop();
    costs_.turns = system.turns();
    costs_.period = system.repeats() ? system.period() : 1.0;
    costs_.tolerance = options.tolerance;
    // A part of a period for impact times; of the amplitude where there are none.
    costs_.allowed = costs_.impacts > 0 ? options.tolerance * costs_.period : options.tolerance;
    costs_.reference_message = reference.message;
  }

  FlowCosts finish() {
    if (!(costs_.end_time > 0.0)) return std::move(costs_);
    measure(system_.turns() ? FlowChoice::kBulirschStoer : FlowChoice::kExact, "", {});
    for (const FlowChoice flow : {FlowChoice::kRk4, FlowChoice::kDopri5, FlowChoice::kFehlberg78})
      climb(flow);
    return std::move(costs_);
  }

 private:
  void climb(FlowChoice flow) {
    StepSetting setting = stable_steps(system_, start_, *step_method(flow));
    setting.speed = options_.speed;
    const bool fixed = setting.method == StepMethod::kRk4;
    double rung = fixed ? 0.5 * std::min(setting.longest, costs_.end_time) : kFirstTolerance;
    for (int i = 0; i < kMostRungs && !options_.stop.requested(); ++i) {
      (fixed ? setting.step : setting.tolerance) = rung;
      const double seconds =
          measure(flow, fmt::format("{}={:.3g}", fixed ? "step" : "tolerance", rung), setting);
      if (seconds > options_.row_seconds) break;
      rung /= fixed ? kStepRatio : kToleranceRatio;
      if (!fixed && rung < 0.99 * kLastTolerance) break;
    }
  }

  // Returns the time that one run takes, s.
  double measure(FlowChoice flow, std::string setting, const std::optional<StepSetting>& steps) {
    SimulationOptions options;
    options.duration = costs_.end_time;
    options.steps = steps;
    options.closure_speed = options_.closure_speed;
    options.max_impacts = options_.max_impacts;
    options.stop = options_.stop;
    FlowCost row;
    row.flow = flow_name(flow);
    row.setting = std::move(setting);
    const TimedRun run = timed_run(system_, start_, options, options_.row_seconds);
    row.seconds_per_period = run.seconds_per_period;
    row.evaluations_per_period = run.evaluations_per_period;
    row.compared = comparison_.of(system_, start_, options);
    costs_.rows.push_back(std::move(row));
    if (options_.progress)
      options_.progress(std::min(1.0, static_cast<double>(costs_.rows.size()) / 24.0));
    return run.seconds;
  }

  const System& system_;
  const State& start_;
  const FlowCostOptions& options_;
  RunComparison comparison_;
  FlowCosts costs_;
};

}  // namespace

FlowCosts flow_costs(const System& system, const State& start, const FlowCostOptions& options) {
  return CostTable(system, start, options).finish();
}

const FlowCost* cheapest(const FlowCosts& costs, double allowed) {
  const FlowCost* best = nullptr;
  for (const FlowCost& row : costs.rows) {
    if (!row.compared.error || !(*row.compared.error <= allowed)) continue;
    if (!best || row.seconds_per_period < best->seconds_per_period) best = &row;
  }
  return best;
}

}  // namespace graze
