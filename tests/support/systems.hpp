// Systems, scenes and runs that several tests build on.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "graze/contact/detail/impulse.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/system/system.hpp"

namespace graze::support {

// One mass-normalised mode: x'' + 2 delta x' + omega^2 x, one stop x <= gap. No forcing.
inline System oscillator(double omega, double delta, double gap, double restitution) {
  System system{Vector::Constant(1, omega), NaturalModes{Vector::Constant(1, delta)}, {}};
  system.stops.push_back({Vector::Ones(1), gap, ImpactLaw{Vector::Ones(1), restitution}});
  return system;
}

inline System forced(System system, double frequency, double phase, const Vector& amplitude) {
  system.modal().forcing = HarmonicForcing{frequency, phase, amplitude};
  return system;
}

// With the force amplitude cos(frequency t) on the only mode.
inline System forced_oscillator(double omega, double delta, double gap, double restitution,
                                double frequency, double amplitude) {
  return forced(oscillator(omega, delta, gap, restitution), frequency, 0.0,
                Vector::Constant(1, amplitude));
}

inline State state_of(const std::vector<double>& q, const std::vector<double>& qdot) {
  const auto n = static_cast<Eigen::Index>(q.size());
  return {Eigen::Map<const Vector>(q.data(), n), Eigen::Map<const Vector>(qdot.data(), n)};
}

inline State rest(const System& system) {
  return {Vector::Zero(system.modes()), Vector::Zero(system.modes())};
}

struct RecordedRun {
  Simulation result;
  std::vector<Event> events;
};

inline RecordedRun record_run(const System& system, const State& start,
                              const SimulationOptions& options) {
  RecordedRun run;
  RunListeners listeners;
  listeners.event = [&run](const Event& event) { run.events.push_back(event); };
  run.result = simulate(system, start, options, listeners);
  return run;
}

inline SimulationOptions for_seconds(double duration) {
  SimulationOptions options;
  options.duration = duration;
  return options;
}

inline SimulationOptions for_periods(long long periods) {
  SimulationOptions options;
  options.periods = periods;
  return options;
}

inline SimulationOptions for_impacts(long long impacts, double duration) {
  SimulationOptions options = for_seconds(duration);
  options.max_impacts = impacts;
  return options;
}

// Random numbers that are the same with every library: mt19937_64 is fixed by the standard, its
// distributions are not.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  int pick(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  Vector vector(int size, double low, double high) {
    Vector v(size);
    for (double& x : v) x = uniform(low, high);
    return v;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace graze::support
