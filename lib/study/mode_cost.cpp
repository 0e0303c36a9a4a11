#include <algorithm>
#include <array>
#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/hybrid/simulation.hpp"
#include "graze/study/accuracy_costs.hpp"
#include "graze/study/timed_run.hpp"

namespace graze {
namespace {

constexpr std::array<int, 12> kNumbers = {1, 2, 3, 4, 5, 6, 8, 12, 16, 24, 32, 48};
// Computing time is taken over so many forcing periods at most.
constexpr double kTimedPeriods = 20.0;

bool is_free(const Scene& scene) {
  if (!scene.beam() || !scene.beam()->points.empty() || scene.initial) return false;
  return !scene.damping || !std::holds_alternative<DampingRatios>(*scene.damping);
}

struct Prepared {
  System system;
  State start;
};

Prepared with_modes(Scene scene, int modes) {
  std::get<Beam>(scene.structure).modes = modes;
  Prepared prepared{assemble(scene), {}};
  prepared.start = initial_state(scene, prepared.system);
  return prepared;
}

std::optional<double> first_impact(const Prepared& beam, const AccuracyCostOptions& options) {
  std::optional<double> time;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    if (event.kind == EventKind::kImpact && !time) time = event.time;
  };
  SimulationOptions one;
  one.duration = options.longest;
  one.max_impacts = 1;
  one.stop = options.stop;
  simulate(beam.system, beam.start, one, listeners);
  return time;
}

}  // namespace

std::vector<ModeCost> mode_costs(const Scene& scene, const AccuracyCostOptions& options) {
  std::vector<ModeCost> rows;
  if (!is_free(scene)) return rows;
  const std::optional<double> meant = first_impact(with_modes(scene, kMostModesCompared), options);
  for (const int modes : kNumbers) {
    if (options.stop.requested()) break;
    const Prepared beam = with_modes(scene, modes);
    const double period = beam.system.forcing ? beam.system.period() : 1.0;
    ModeCost row;
    row.modes = modes;
    const std::optional<double> time = first_impact(beam, options);
    if (time && meant) row.error = std::abs(*time - *meant);
    SimulationOptions timed;
    timed.duration = std::min(options.longest, kTimedPeriods * period);
    timed.stop = options.stop;
    const TimedRun run = timed_run(beam.system, beam.start, timed);
    if (!(run.run.end_time > 0.0)) continue;
    row.seconds_per_period = run.seconds_per_period;
    row.evaluations_per_period = run.evaluations_per_period;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace graze
