#include "graze/study/sweep/run_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/assembly/probes.hpp"
#include "graze/base/angle.hpp"
#include "graze/scene/start_coordinate.hpp"
#include "graze/study/cost/step_choice.hpp"

namespace graze {
namespace {

constexpr double kSamplesPerOscillation = 20.0;

// The largest size of a series of values at equal distances. Extremes between them lie on the
// quartics through five values: an oscillation with 20 of them is known to (pi/10)^6/720 or so.
class Peak {
 public:
  void add(double value) {
    largest_ = std::max(largest_, std::abs(value));
    std::rotate(last_.begin(), last_.begin() + 1, last_.end());
    last_.back() = value;
    if (++count_ >= 5) look_between();
  }
  double largest() const { return largest_; }

 private:
  // Examines the quartic about the middle of the five, in units of the distance.
  void look_between() {
    const auto [a, b, c, d, e] = last_;
    const double even = 0.5 * (b + d) - c, far_even = 0.5 * (a + e) - c;
    const double odd = 0.5 * (d - b), far_odd = 0.5 * (e - a);
    const double x4 = (far_even - 4.0 * even) / 12.0, x2 = even - x4;
    const double x3 = (far_odd - 2.0 * odd) / 6.0, x1 = odd - x3;
    // The parabola's vertex; it lies within half a distance where the middle is the extreme.
    if (x2 == 0.0 || std::abs(x1) > std::abs(x2)) return;
    double x = -0.5 * x1 / x2;
    for (int turn = 0; turn < 3; ++turn) {
      const double slope = x1 + x * (2.0 * x2 + x * (3.0 * x3 + x * 4.0 * x4));
      const double curvature = 2.0 * x2 + x * (6.0 * x3 + x * 12.0 * x4);
      if (curvature == 0.0) return;
      x -= slope / curvature;
    }
    if (std::abs(x) <= 1.0)
      largest_ = std::max(largest_, std::abs(c + x * (x1 + x * (x2 + x * (x3 + x * x4)))));
  }

  std::array<double, 5> last_{};
  double largest_ = 0.0;
  long long count_ = 0;
};

// Returns nullopt when it was stopped.
std::optional<ValueRun> run_at(const Scene& scene, double value, const RunSeriesOptions& series) {
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  const std::vector<ProbeRow> probes = probe_rows(scene, system);
  SimulationOptions options;
  options.duration = series.duration;
  options.steps = step_choice(scene, system, start);
  options.max_impacts = series.max_impacts;
  options.closure_speed =
      series.closure_speed.value_or(default_closure_speed(system, start, scene.solver.tolerance));
  options.stop = series.stop;
  ValueRun run;
  run.value = value;
  std::vector<Peak> peaks(probes.size());
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    if (meets_stop(event)) run.impacts.push_back({event.time, event.stop, event.speed});
  };
  if (!probes.empty())
    listeners.sample = [&](const Sample& sample) {
      const State own = structure_state(system, sample.state, sample.phase);
      for (std::size_t i = 0; i < probes.size(); ++i) peaks[i].add(probes[i].value(own));
    };
  // As many samples over the run where nothing oscillates.
  listeners.sample_rate =
      kSamplesPerOscillation * std::max(system.omega.maxCoeff() / kTurn, 1.0 / series.duration);
  const Simulation end = simulate(system, start, options, listeners);
  if (end.outcome == RunOutcome::kInterrupted || end.outcome == RunOutcome::kTimeBudget) return {};
  run.outcome = end.outcome;
  run.message = end.message;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    run.peaks.push_back(peaks[i].largest());
    run.ends.push_back(probes[i].value(structure_state(system, end.final, end.phase)));
  }
  return run;
}

}  // namespace

std::vector<ValueRun> run_series(const Scene& scene, const RunSeriesOptions& options) {
  // A value that the scene does not allow is reported before any run.
  std::vector<Scene> scenes;
  scenes.reserve(options.values.size());
  for (const double value : options.values) {
    scenes.push_back(with_number(scene, options.parameter, value));
    initial_state(scenes.back(), assemble(scenes.back()));
  }
  MadePieces<ValueRun> made = make_pieces<ValueRun>(
      "row", scenes.size(), options,
      [&](std::size_t i) { return run_at(scenes[i], options.values[i], options); });
  std::vector<ValueRun> finished;
  for (std::optional<ValueRun>& run : made.pieces)
    if (run) finished.push_back(std::move(*run));
  return finished;
}

}  // namespace graze
