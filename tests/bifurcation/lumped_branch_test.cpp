// Branches over the numbers of masses and springs, against what runs settle on.
#include <gtest/gtest.h>

#include "branch_checks.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/base/angle.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// The last impact of a run of so many periods from rest.
Event last_impact(const Scene& scene, int periods) {
  const System system = assemble(scene);
  SimulationOptions options;
  options.periods = periods;
  Event last;
  RunListeners listeners;
  listeners.event = [&last](const Event& event) {
    if (event.kind == EventKind::kImpact) last = event;
  };
  simulate(system, initial_state(scene, system), options, listeners);
  return last;
}

void expect_runs_settle_there(const Scene& scene, const std::string& name, double from, double to) {
  SCOPED_TRACE(name);
  const OrbitBranches result = support::trace(scene, name, from, to, false);
  ASSERT_EQ(result.branches.size(), 1u);
  const std::vector<OrbitBranchPoint>& points = result.branches[0].points;
  EXPECT_EQ(points.front().value, from);
  EXPECT_EQ(points.back().value, to);
  int compared = 0;
  for (std::size_t i = 0; i < points.size(); i += 8) {
    if (points[i].orbit.stable != true) continue;
    const Event run = last_impact(with_parameter(scene, name, points[i].value), 400);
    const OrbitImpact& impact = points[i].orbit.impacts[0];
    EXPECT_NEAR(impact.speed, run.speed, 1e-9 * run.speed) << points[i].value;
    EXPECT_NEAR(std::remainder(impact.phase - run.phase.value(), kTurn), 0.0, 1e-9) << points[i].value;
    ++compared;
  }
  EXPECT_GE(compared, 5);
}

// One dashpot to the ground couples the modes; from rest all runs come to the (1, 1) orbit.
TEST(LumpedBranches, AreWhatRunsSettleOn) {
  const Scene scene = support::reference_scene("coupled/dashpot", {"lumped.masses.2=1.0"});
  expect_runs_settle_there(scene, "lumped.spring.1.stiffness", 35.0, 45.0);
  expect_runs_settle_there(scene, "lumped.spring.1.damping", 1.0, 2.0);
  expect_runs_settle_there(scene, "lumped.masses.2", 0.8, 1.2);
}

// Where the two arms of a hub are equal, a mode leaves the hub at rest and changes its sign.
TEST(LumpedBranches, PassWhereAModeChangesItsSign) {
  const Scene scene = parse_scene(
      "[lumped]\nmasses = [1.0, 1.0, 1.0]\n"
      "[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 100\ndamping = 0.5\n"
      "[[lumped.spring]]\nbetween = [1, 2]\nstiffness = 100\ndamping = 0.7\n"
      "[[lumped.spring]]\nbetween = [1, 3]\nstiffness = 100\ndamping = 0.7\n"
      "[forcing]\nmass = 1\namplitude = 5\nfrequency = 10\n"
      "[[stop]]\nmass = 2\ngap = 0.01\nrestitution = 0.2\n",
      "hub");
  for (const auto& [name, from, to] : {std::tuple("lumped.spring.2.stiffness", 95.0, 106.0),
                                       std::tuple("lumped.masses.2", 0.95, 1.05)}) {
    const OrbitBranches result = support::trace(scene, name, from, to, false);
    ASSERT_EQ(result.branches.size(), 1u) << name;
    EXPECT_EQ(result.branches[0].points.front().value, from) << name;
    EXPECT_EQ(result.branches[0].points.back().value, to) << name;
  }
}

}  // namespace
}  // namespace graze
