// The periodic orbits of a scene: where they impact, whether they are stable, and whether the
// structure passes through a stop in between.
//
//   example_orbit [SCENE.toml]     run from the project's root
#include <cstdio>
#include <exception>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/scene/reader.hpp"

using namespace graze;

int main(int count, char** words) try {
  const Scene scene = read_scene(count > 1 ? words[1] : "data/scenes/05_wagg_one_mode.toml",
                                 {"forcing.frequency=40"});
  const System system = assemble(scene);

  FinderOptions options;
  options.period = 1;           // forcing periods,
  options.impacts = 1;          // impacts,
  options.keep_virtual = true;  // and solutions that penetrate or impact backwards too
  const FoundOrbits found = find_orbits(system, initial_state(scene, system), options);

  for (const Orbit& orbit : found.orbits) {
    for (const OrbitImpact& impact : orbit.impacts)
      std::printf("phase %.12f rad, speed %.12f m/s\n", impact.phase, impact.speed);
    for (const Eigenvalue& multiplier : orbit.multipliers)
      std::printf("  multiplier %.9f %+.9fi\n", multiplier.value.real(), multiplier.value.imag());
    std::printf("  %s, %s\n", orbit.admissible ? "admissible" : "virtual",
                !orbit.stable   ? "on the boundary of stability"
                : *orbit.stable ? "stable"
                                : "unstable");
  }
  for (const std::string& note : found.notes) std::printf("%s\n", note.c_str());
  return found.orbits.empty() ? 3 : 0;
} catch (const std::exception& error) {  // a scene that cannot be used: file:line:column, why
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
