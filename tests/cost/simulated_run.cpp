// The program whose instructions the tests of this folder count:
//   simulated_run SCENE PERIODS SAMPLES ENERGY [setting..]
// SAMPLES: per forcing period (or second), 0: none. ENERGY: 1 keeps the energy balance.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/scene/reader.hpp"

int main(int count, char** words) {
  using namespace graze;
  if (count < 5) return 2;
  const Scene scene = read_scene(words[1], std::vector<std::string>(words + 5, words + count));
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  SimulationOptions options;
  const double period = system.forcing() ? system.period() : 1.0;
  options.duration = std::atof(words[2]) * period;
  options.energy = std::atoi(words[4]) != 0;
  RunListeners listeners;
  double sum = 0.0;
  if (std::atof(words[3]) > 0.0) {
    listeners.sample = [&](const Sample& sample) { sum += sample.state.q[0]; };
    listeners.sample_rate = std::atof(words[3]) / period;
  }
  const Simulation run = simulate(system, start, options, listeners);
  std::printf("%lld impacts, %lld evaluations, %.17g\n", run.totals.impacts, run.evaluations, sum);
  return run.outcome == RunOutcome::kReachedEnd ? 0 : 1;
}
