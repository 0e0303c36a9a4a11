#include "graze/study/cost/detail/stepped_reference.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "graze/motion/simulation.hpp"
#include "graze/study/cost/step_choice.hpp"

namespace graze {
namespace {

constexpr double kTolerance = 1e-15;  // of a step of the Runge-Kutta pair
constexpr double kSamples = 64.0;     // of a motion without impacts

struct SteppedRun {
  std::vector<ReferenceImpact> impacts;
  std::vector<State> samples;
  Simulation end;
};

SteppedRun run(const System& system, const State& start, const std::optional<StepSetting>& steps,
               double duration, const ReferenceOptions& options, double sample_rate = 0.0) {
  SteppedRun found;
  SimulationOptions simulation;
  simulation.duration = duration;
  simulation.steps = steps;
  simulation.closure_speed = options.slowest;
  simulation.stop = options.stop;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    const bool leaves = event.kind == EventKind::kSeparation;
    const bool met = event.kind == EventKind::kImpact || event.kind == EventKind::kContact;
    if (!(met || leaves) || (event.kind == EventKind::kImpact && !(event.speed > options.slowest)))
      return;
    found.impacts.push_back({event.time, event.stop, event.speed, leaves});
  };
  if (sample_rate > 0.0) {
    listeners.sample_rate = sample_rate;
    listeners.sample = [&](const Sample& sample) {
      if (sample.time > 0.0) found.samples.push_back(sample.state);
    };
  }
  found.end = simulate(system, start, simulation, listeners);
  return found;
}

// Number of leading instants that agree in the two runs.
std::size_t agreeing(const std::vector<ReferenceImpact>& a, const std::vector<ReferenceImpact>& b) {
  std::size_t count = 0;
  while (count < a.size() && count < b.size() && a[count].stop == b[count].stop &&
         a[count].leaves == b[count].leaves &&
         std::abs(a[count].time - b[count].time) <= kVouchedTime)
    ++count;
  return count;
}

}  // namespace

ReferenceRun stepped_reference(const System& system, const State& start,
                               const ReferenceOptions& options) {
  StepSetting setting = stable_steps(system, start, StepMethod::kFehlberg78);
  setting.tolerance = kTolerance;
  const SteppedRun pair = run(system, start, setting, options.longest, options);
  const SteppedRun other = run(system, start, {}, options.longest, options);
  ReferenceRun reference;
  std::size_t vouched = agreeing(pair.impacts, other.impacts);
  // Keeps whole contacts, and no more than requested.
  std::size_t met = 0, kept = 0;
  while (kept < vouched && met < options.impacts) met += pair.impacts[kept++].leaves ? 0u : 1u;
  if (kept < vouched && pair.impacts[kept].leaves) ++kept;
  if (kept < pair.impacts.size() && pair.impacts[kept].leaves) --kept;
  reference.impacts.assign(pair.impacts.begin(),
                           pair.impacts.begin() + static_cast<std::ptrdiff_t>(kept));
  if (vouched < std::max(pair.impacts.size(), other.impacts.size()) && met < options.impacts)
    reference.message = fmt::format("two methods agree on {} of its instants to {:g}{}", vouched,
                                    kVouchedTime, unit_behind(system.units, "s"));
  reference.end_time = options.longest;
  if (kept < pair.impacts.size()) {
    const double last = kept > 0 ? pair.impacts[kept - 1].time : 0.0;
    reference.end_time = 0.5 * (last + pair.impacts[kept].time);
  }
  reference.sample_interval = reference.end_time / kSamples;
  const bool samples = reference.impacts.empty();
  const SteppedRun last = run(system, start, setting, reference.end_time, options,
                              samples ? 1.0 / reference.sample_interval : 0.0);
  reference.end = last.end.final;
  reference.samples = last.samples;
  if (options.stop.requested()) reference.end_time = 0.0;
  return reference;
}

}  // namespace graze
