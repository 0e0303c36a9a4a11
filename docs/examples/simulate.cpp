// The motion of a scene from its initial state, with every impact as it happens.
//
//   example_simulate [SCENE.toml]     run from the project's root
#include <cstdio>
#include <exception>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/scene/reader.hpp"

using namespace graze;

int main(int count, char** words) try {
  // What the file says; then the equations that it stands for.
  const Scene scene = read_scene(count > 1 ? words[1] : "data/scenes/05_wagg_one_mode.toml");
  const System system = assemble(scene);

  SimulationOptions options;
  options.duration = 1.5;  // s
  options.energy = true;   // keep the balance of what forcing, damping and impacts do
  RunListeners listeners;
  listeners.event = [](const Event& event) {
    if (event.kind == EventKind::kImpact)
      std::printf("impact at %.9f s, %.9f m/s, %.6e J\n", event.time, event.speed,
                  event.energy_change);
  };
  const Simulation run = simulate(system, initial_state(scene, system), options, listeners);

  std::printf("%lld impacts took %.6e J\n", run.totals.impacts, run.totals.energy_lost);
  if (run.outcome == RunOutcome::kReachedEnd) return 0;
  std::printf("%s\n", run.message.c_str());  // why it ended early
  return 3;
} catch (const std::exception& error) {  // a scene that cannot be used: file:line:column, why
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
