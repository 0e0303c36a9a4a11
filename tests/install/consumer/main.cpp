// A project of its own that uses the installed library: the orbit of the shipped one-mode beam.
#include <cmath>
#include <iostream>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/scene/reader.hpp"

int main(int, char** argv) {
  const graze::Scene scene = graze::read_scene(argv[1], {"forcing.frequency=40"});
  const graze::System system = graze::assemble(scene);
  const graze::FoundOrbits found =
      graze::find_orbits(system, graze::initial_state(scene, system), {});
  for (const graze::Orbit& orbit : found.orbits)
    std::cout << orbit.impacts.front().phase << " " << orbit.impacts.front().speed << "\n";
  // Independent 40-digit value of the phase.
  return !found.orbits.empty() &&
                 std::abs(found.orbits.front().impacts.front().phase - 0.201791940738459) < 1e-12
             ? 0
             : 1;
}
