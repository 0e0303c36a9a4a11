#include "graze/orbit/search/detail/self_excited.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "graze/base/units.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// Periods of the slowest mode that are followed; the most slips of one cycle, and how many cycles
// have to agree, to which part.
constexpr double kOscillations = 400.0;
constexpr std::size_t kMostSlips = 64;
constexpr std::size_t kCycles = 3;
constexpr double kSameLapse = 1e-6;
// Samples of the last cycle among which one is near the place's rest: Newton's method does the
// rest.
constexpr double kSamples = 512.0;

struct Slip {
  double time = 0.0;
  int friction = 0, direction = 0;
};

// After how many slips the last ones repeat; 0: they do not.
std::size_t repetition(const std::vector<Slip>& slips) {
  const std::size_t n = slips.size();
  for (std::size_t m = 1; m <= kMostSlips && kCycles * m < n; ++m) {
    const double period = slips[n - 1].time - slips[n - 1 - m].time;
    bool same = true;
    for (std::size_t i = n - 1; i + (kCycles - 1) * m >= n && same; --i) {
      const Slip &a = slips[i], &b = slips[i - m];
      same = a.friction == b.friction && a.direction == b.direction &&
             std::abs(a.time - b.time - period) <= kSameLapse * period;
    }
    if (same) return m;
  }
  return 0;
}

// The system without the guess of a period, with which motions would be cut.
System undriven(const System& system) {
  System free = system;
  free.modal().forcing.reset();
  return free;
}

}  // namespace

SelfExcitedAnswer self_excited_cycle(const System& system, const State& start,
                                     const StopSignal& stop) {
  const System free = undriven(system);
  double slowest = system.omega.minCoeff();
  if (!(slowest > 0.0)) slowest = system.forcing()->frequency;
  std::vector<Slip> slips;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    if (event.kind == EventKind::kSlip || event.kind == EventKind::kReversal)
      slips.push_back({event.time, event.friction, event.direction});
  };
  SimulationOptions options;
  options.duration = kOscillations * kTurn / slowest;
  options.stop = stop;
  const Simulation run = simulate(free, start, options, listeners);
  if (run.outcome != RunOutcome::kReachedEnd) return {{}, run.message};
  const std::size_t m = repetition(slips);
  if (m == 0)
    return {{},
            slips.empty() || slips.back().time < 0.5 * run.end_time
                ? "from the scene's initial state the motion comes to rest, or slides for ever"
                : "from the scene's initial state the slips repeat no pattern"};
  SelfExcitedCycle cycle{slips.back().time - slips[slips.size() - 1 - m].time, {}};
  // Over one cycle more, from where it has settled.
  const Vector& row = system.frictions.front().row;
  double before = 0.0;
  listeners.event = {};
  listeners.sample_rate = kSamples / cycle.period;
  listeners.sample = [&](const Sample& sample) {
    const double speed = row.dot(sample.state.qdot);
    if (cycle.start.q.size() == 0 && before > 0.0 && speed <= 0.0) cycle.start = sample.state;
    before = speed;
  };
  options.duration = 2.0 * cycle.period;
  simulate(free, run.final, options, listeners);
  if (cycle.start.q.size() == 0)
    return {{}, "the place of the first friction never turns back along the motion"};
  return {cycle, fmt::format("from the scene's initial state the motion settles on a cycle of "
                             "{:.9g}{}",
                             cycle.period, unit_behind(system.units, "s"))};
}

FollowedAnswer self_excited_orbit(const System& system, const State& start,
                                  const SegmentOptions& options, std::vector<std::string>& notes) {
  const SelfExcitedAnswer answer = self_excited_cycle(system, start, options.stop);
  notes.push_back(answer.classification);
  if (!answer.cycle) return {};
  System timed = system;
  timed.modal().forcing->frequency = kTurn / answer.cycle->period;
  return followed_orbit(timed, std::vector{answer.cycle->start}, options);
}

}  // namespace graze
