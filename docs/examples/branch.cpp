// A branch of periodic orbits over the gap of the stop: its special points and how it ends.
//
//   example_branch [SCENE.toml]     run from the project's root
#include <cstdio>
#include <exception>

#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/scene/reader.hpp"

using namespace graze;

int main(int count, char** words) try {
  const Scene scene = read_scene(count > 1 ? words[1] : "data/scenes/05_wagg_one_mode.toml",
                                 {"forcing.frequency=40"});
  const SystemFamily family(scene, "stop.gap");  // or "forcing.frequency", "stop.restitution", ..

  BranchOptions options;
  options.period = 1;   // forcing periods
  options.impacts = 1;  // and impacts of an orbit
  options.from = 0.0;   // m
  options.to = 0.02;    // m
  const OrbitBranches traced = trace_orbits(family, options);

  for (const OrbitBranch& branch : traced.branches) {
    int stable = 0;
    for (const OrbitBranchPoint& point : branch.points) stable += point.unstable_multipliers == 0;
    std::printf("branch %d from %.9f to %.9f m, %s\n", branch.id, branch.points.front().value,
                branch.points.back().value, stable > 0 ? "stable in part" : "unstable");
    for (const SpecialPoint& special : branch.special) {
      std::printf("  %s at %.12f m", special.id.c_str(), special.at.value);
      if (const auto impact = special.impact())
        std::printf(", impact at phase %.9f rad", impact->phase);
      std::printf("\n");
    }
  }
  for (const std::string& note : traced.notes) std::printf("%s\n", note.c_str());
  return traced.branches.empty() ? 3 : 0;
} catch (const std::exception& error) {  // a scene that cannot be used: file:line:column, why
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
