#include "graze/study/flow_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "graze/hybrid/simulation.hpp"
#include "graze/study/step_choice.hpp"

namespace graze {
namespace {

// A run is repeated until so much time has gone by, and at least so often; the least counts, for
// what else the machine does only adds to it.
constexpr double kMeasured = 0.02;  // s
constexpr int kFewestRuns = 3;
// From one rung of a ladder to the next a step gets shorter by this factor, a tolerance smaller by
// the other.
constexpr double kStepRatio = 4.0, kToleranceRatio = 100.0;
constexpr double kFirstTolerance = 1e-2, kLastTolerance = 1e-14;
constexpr int kMostRungs = 14;

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct ComparedRun {
  Simulation result;
  std::vector<ReferenceImpact> impacts;
  std::vector<State> samples;
};

class CostTable {
 public:
  CostTable(const System& system, const State& start, const FlowCostOptions& options)
      : system_(system),
        start_(start),
        options_(options),
        reference_(reference_run(
            system, start,
            {options.impacts, options.closure_speed, options.longest, options.stop})) {
    costs_.impacts = std::min(reference_.impacts.size(), options.impacts);
    costs_.end_time = reference_.end_time;
    costs_.period = system.forcing ? system.period() : 1.0;
    costs_.tolerance = options.tolerance;
    // A part of a period for impact times; of the amplitude where there are none.
    costs_.allowed = costs_.impacts > 0 ? options.tolerance * costs_.period : options.tolerance;
    costs_.reference_message = reference_.message;
  }

  FlowCosts finish() {
    if (!(costs_.end_time > 0.0)) return std::move(costs_);
    measure("exact", "", {});
    for (const FlowChoice flow : {FlowChoice::kRk4, FlowChoice::kDopri5, FlowChoice::kFehlberg78})
      climb(flow);
    return std::move(costs_);
  }

 private:
  void climb(FlowChoice flow) {
    StepSetting setting;
    setting.method = *step_method(flow);
    setting.speed = options_.speed;
    setting.longest = longest_stable_step(system_, setting.method);
    if (std::isinf(setting.longest)) setting.longest = costs_.end_time;
    const bool fixed = setting.method == StepMethod::kRk4;
    double rung = fixed ? 0.5 * setting.longest : kFirstTolerance;
    for (int i = 0; i < kMostRungs && !options_.stop.requested(); ++i) {
      (fixed ? setting.step : setting.tolerance) = rung;
      const double seconds = measure(
          flow_name(flow), fmt::format("{}={:.3g}", fixed ? "step" : "tolerance", rung), setting);
      if (seconds > options_.row_seconds) break;
      rung /= fixed ? kStepRatio : kToleranceRatio;
      if (!fixed && rung < 0.99 * kLastTolerance) break;
    }
  }

  SimulationOptions simulation_options(const std::optional<StepSetting>& steps) const {
    SimulationOptions options;
    options.duration = costs_.end_time;
    options.steps = steps;
    options.closure_speed = options_.closure_speed;
    options.stop = options_.stop;
    return options;
  }

  // Returns the time that one run takes, s.
  double measure(const std::string& flow, std::string setting,
                 const std::optional<StepSetting>& steps) {
    FlowCost row;
    row.flow = flow;
    row.setting = std::move(setting);
    const SimulationOptions options = simulation_options(steps);
    double least = 0.0, total = 0.0;
    for (int i = 0; i < kFewestRuns || total < kMeasured; ++i) {
      const double before = processor_time();
      const Simulation run = simulate(system_, start_, options);
      const double seconds = processor_time() - before;
      row.evaluations_per_period =
          static_cast<double>(run.evaluations) * costs_.period / costs_.end_time;
      least = i == 0 ? seconds : std::min(least, seconds);
      total += seconds;
      if (total > options_.row_seconds) break;
    }
    row.seconds_per_period = least * costs_.period / costs_.end_time;
    compare(options, row);
    costs_.rows.push_back(std::move(row));
    if (options_.progress)
      options_.progress(std::min(1.0, static_cast<double>(costs_.rows.size()) / 24.0));
    return least;
  }

  void compare(const SimulationOptions& options, FlowCost& row) const {
    const ComparedRun run = compared_run(options);
    if (run.result.outcome != RunOutcome::kReachedEnd) {
      row.message = run.result.message;
      return;
    }
    row.impacts_agree = agree(run.impacts);
    if (!row.impacts_agree) return;
    row.error = costs_.impacts > 0 ? std::optional(time_error(run.impacts))
                                   : displacement_error(run.samples);
    if (reference_.message.empty()) row.state_error = state_error(run.result.final);
  }

  ComparedRun compared_run(const SimulationOptions& options) const {
    ComparedRun run;
    RunListeners listeners;
    listeners.event = [&](const Event& event) {
      if (event.kind == EventKind::kImpact && event.speed > options_.closure_speed)
        run.impacts.push_back({event.time, event.stop, event.speed});
    };
    if (costs_.impacts == 0) {
      listeners.sample = [&](const Sample& sample) { run.samples.push_back(sample.state); };
      listeners.sample_rate = 1.0 / reference_.sample_interval;
    }
    run.result = simulate(system_, start_, options, listeners);
    return run;
  }

  // One too many is as wrong as one too few; and each has to be nearer to the impact that it stands
  // for than to any other on that stop.
  bool agree(const std::vector<ReferenceImpact>& impacts) const {
    const std::vector<ReferenceImpact>& meant = reference_.impacts;
    // Where the reference had to end early another may come there or not.
    const bool cut = !reference_.message.empty();
    if (cut ? impacts.size() < meant.size() : impacts.size() != meant.size()) return false;
    for (std::size_t i = 0; i < meant.size(); ++i) {
      if (impacts[i].stop != meant[i].stop) return false;
      const double off = std::abs(impacts[i].time - meant[i].time);
      for (std::size_t k = 0; k < meant.size(); ++k)
        if (k != i && meant[k].stop == meant[i].stop &&
            std::abs(impacts[i].time - meant[k].time) < off)
          return false;
    }
    return true;
  }

  double time_error(const std::vector<ReferenceImpact>& impacts) const {
    double error = 0.0;
    for (std::size_t i = 0; i < costs_.impacts; ++i)
      error = std::max(error, std::abs(impacts[i].time - reference_.impacts[i].time));
    return error;
  }

  // Nothing where none was compared.
  std::optional<double> displacement_error(const std::vector<State>& samples) const {
    if (reference_.samples.empty()) return {};
    double error = 0.0, size = 0.0;
    // The first sample of the run is its start.
    for (std::size_t i = 0; i < reference_.samples.size() && i + 1 < samples.size(); ++i) {
      size = std::max(size, reference_.samples[i].q.norm());
      error = std::max(error, (samples[i + 1].q - reference_.samples[i].q).norm());
    }
    return size > 0.0 ? error / size : error;
  }

  double state_error(const State& end) const {
    const Vector displacement = system_.omega.cwiseProduct(end.q - reference_.end.q);
    return std::hypot(displacement.norm(), (end.qdot - reference_.end.qdot).norm()) /
           options_.speed;
  }

  const System& system_;
  const State& start_;
  const FlowCostOptions& options_;
  ReferenceRun reference_;
  FlowCosts costs_;
};

}  // namespace

FlowCosts flow_costs(const System& system, const State& start, const FlowCostOptions& options) {
  return CostTable(system, start, options).finish();
}

const FlowCost* cheapest(const FlowCosts& costs, double allowed) {
  const FlowCost* best = nullptr;
  for (const FlowCost& row : costs.rows) {
    if (!row.error || !(*row.error <= allowed)) continue;
    if (!best || row.seconds_per_period < best->seconds_per_period) best = &row;
  }
  return best;
}

}  // namespace graze
