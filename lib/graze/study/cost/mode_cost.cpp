#include <algorithm>
#include <cmath>
#include <set>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/scene/check.hpp"
#include "graze/study/cost/accuracy_costs.hpp"
#include "graze/study/cost/timed_run.hpp"

namespace graze {
namespace {

// Computing time is measured over at most this many forcing periods.
constexpr double kTimedPeriods = 20.0;

int most_compared(const Scene& scene) { return scene.hub ? kMostModesOnHub : kMostModesCompared; }

// The numbers of modes to compare, with the scene's own.
std::set<int> numbers(const Scene& scene) {
  std::set<int> list = {1, 2, 3, 4, 5, 6, 8, 12, 16, 24, 32, 48, scene.modes()};
  std::erase_if(list, [most = most_compared(scene)](int modes) { return modes >= most; });
  return list;
}

bool is_free(const Scene& scene) {
  if (!scene.beam() || !scene.beam()->points.empty() || scene.initial) return false;
  return !scene.damping || !std::holds_alternative<DampingRatios>(*scene.damping);
}

struct Prepared {
  System system;
  State start;
};

// Returns nullopt when the scene does not allow that number: its stop may be no collocation point.
std::optional<Prepared> with_modes(Scene scene, int modes) {
  std::get<Beam>(scene.structure).modes = modes;
  try {
    check_scene(scene);
  } catch (const InputError&) {
    return {};
  }
  Prepared prepared{assemble(scene), {}};
  prepared.start = initial_state(scene, prepared.system);
  return prepared;
}

std::optional<double> first_impact(const Prepared& beam, const AccuracyCostOptions& options) {
  std::optional<double> time;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    const bool meets = event.kind == EventKind::kImpact || event.kind == EventKind::kContact;
    if (meets && !time) time = event.time;
  };
  SimulationOptions one;
  one.duration = options.longest;
  one.closure_speed = options.closure_speed;
  one.max_impacts = 1;
  one.stop = options.stop;
  simulate(beam.system, beam.start, one, listeners);
  return time;
}

}  // namespace

std::vector<ModeCost> mode_costs(const Scene& scene, const AccuracyCostOptions& options) {
  std::vector<ModeCost> rows;
  if (!is_free(scene)) return rows;
  const std::optional<Prepared> many = with_modes(scene, most_compared(scene));
  const std::optional<double> meant = many ? first_impact(*many, options) : std::nullopt;
  for (const int modes : numbers(scene)) {
    if (options.stop.requested()) break;
    const std::optional<Prepared> beam = with_modes(scene, modes);
    if (!beam) continue;
    const double period = beam->system.forcing() ? beam->system.period() : 1.0;
    ModeCost row;
    row.modes = modes;
    const std::optional<double> time = first_impact(*beam, options);
    if (time && meant) row.error = std::abs(*time - *meant);
    SimulationOptions timed;
    timed.duration = std::min(options.longest, kTimedPeriods * period);
    timed.closure_speed = options.closure_speed;
    timed.max_impacts = options.max_impacts;
    timed.stop = options.stop;
    const TimedRun run = timed_run(beam->system, beam->start, timed);
    if (run.run.outcome != RunOutcome::kReachedEnd) continue;
    row.seconds_per_period = run.seconds_per_period;
    row.evaluations_per_period = run.evaluations_per_period;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace graze
