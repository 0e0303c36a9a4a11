// Orbits that rest on a rigid stop while they compress a spring: their branches against runs, and
// their grazings from both sides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "branch_checks.hpp"
#include "graze/assembly/assembly.hpp"
#include "orbit/mixed_scenes.hpp"

namespace graze {
namespace {

// The fastest impact in the last period of a run from the scene's initial state.
double fastest_of_run(const Scene& scene) {
  const System system = assemble(scene);
  SimulationOptions options;
  options.periods = 150;
  double fastest = 0.0;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    const bool hits = event.kind == EventKind::kImpact || event.kind == EventKind::kContact;
    if (hits && event.period_index >= 148) fastest = std::max(fastest, event.speed);
  };
  simulate(system, initial_state(scene, system), options, listeners);
  return fastest;
}

void compare_with_runs(const Scene& scene, const std::string& parameter, double from, double to) {
  SCOPED_TRACE(scene.title);
  const OrbitBranches traced = support::trace_from_runs(
      scene, parameter, {.from = from, .to = to, .max_step = 0.2 * (to - from), .start_values = 0});
  ASSERT_FALSE(traced.branches.empty());
  int compared = 0;
  for (const OrbitBranch& branch : traced.branches) {
    ASSERT_TRUE(branch.sticks());
    for (const std::size_t part : {1u, 2u}) {
      const OrbitBranchPoint& point = branch.points[part * branch.points.size() / 3];
      if (point.orbit.stable != true || branch.points.size() < 6) continue;
      EXPECT_TRUE(std::any_of(point.orbit.impacts.begin(), point.orbit.impacts.end(),
                              [](const OrbitImpact& impact) { return impact.contact; }));
      double fastest = 0.0;
      for (const OrbitImpact& impact : point.orbit.impacts)
        fastest = std::max(fastest, impact.speed);
      EXPECT_NEAR(fastest_of_run(with_parameter(scene, parameter, point.value)) / fastest, 1.0,
                  1e-8)
          << point.value;
      ++compared;
    }
  }
  EXPECT_GE(compared, 2);
}

TEST(MixedOrbits, AreWhatRunsSettleOn) {
  compare_with_runs(support::held_against_dashpot(), "forcing.frequency", 0.39, 0.41);
  compare_with_runs(support::held_against_ball(), "stop.2.spring.stiffness", 34.6, 35.6);
  compare_with_runs(support::held_beam(), "forcing.amplitude", 2.49e-3, 2.51e-3);
}

// Where the force of the spring sets in with a jump the map has a corner as a contact is born.
TEST(MixedOrbits, GrazeTheSpringWhereTheirNeighboursDo) {
  const OrbitBranches traced =
      support::trace_from_runs(support::held_against_dashpot(), "forcing.frequency",
                               {.from = 0.34, .to = 0.352, .max_step = 0.002, .start_values = 6});
  const auto grazings = support::special_points(traced, SpecialKind::kGrazing);
  int pairs = 0;
  for (const SpecialPoint* one : grazings)
    for (const SpecialPoint* other : grazings) {
      if (one >= other || std::abs(one->at.value - other->at.value) > 1e-4) continue;
      EXPECT_NEAR(one->at.value / other->at.value, 1.0, 1e-9);
      ++pairs;
    }
  EXPECT_GE(pairs, 1);
}

}  // namespace
}  // namespace graze
