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

void expect_one_branch(const Scene& scene, const std::string& name, double from, double to,
                       bool sticking = false) {
  SCOPED_TRACE(name);
  BranchOptions options;
  options.from = from;
  options.to = to;
  const OrbitBranches result = sticking ? support::sticking_branches(scene, name, options)
                                        : support::trace(scene, name, from, to, false);
  ASSERT_EQ(result.branches.size(), 1u);
  EXPECT_EQ(result.branches[0].points.front().value, from);
  EXPECT_EQ(result.branches[0].points.back().value, to);
}

// Where the two arms of a hub are equal, a mode leaves the hub at rest and changes its sign. Orbits
// of impacts, orbits that are followed because dashpots couple the modes, and orbits that stick.
TEST(LumpedBranches, PassWhereAModeChangesItsSign) {
  const std::vector<std::string> ratio{"damping.ratio=0.05"},
      dashpots{"lumped.spring.1.damping=0.5", "lumped.spring.2.damping=0.7",
               "lumped.spring.3.damping=0.7"};
  for (const std::vector<std::string>& settings : {ratio, dashpots}) {
    const Scene scene = support::reference_scene("lumped/hub", settings);
    expect_one_branch(scene, "lumped.spring.2.stiffness", 95.0, 106.0);
    expect_one_branch(scene, "lumped.masses.2", 0.95, 1.05);
  }
  const Scene sticking = support::reference_scene("lumped/hub", {"damping.ratio=0.05", "forcing.frequency=3.0"});
  expect_one_branch(sticking, "lumped.spring.2.stiffness", 95.0, 106.0, true);
  expect_one_branch(sticking, "lumped.masses.2", 0.95, 1.05, true);
}

// Two frequencies that cross without meeting.
TEST(LumpedBranches, PassWhereModesChangeTheirOrder) {
  const Scene scene = support::reference_scene("lumped/apart");
  expect_one_branch(scene, "lumped.spring.2.stiffness", 80.0, 140.0);
  expect_one_branch(scene, "lumped.masses.1", 0.7, 1.2);
}

}  // namespace
}  // namespace graze
