// From branches of orbits that stick onto those that leave them: doubled orbits at PD, and at BP
// the branch that crosses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "branch_checks.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

OrbitBranches followed(const Scene& scene, double from, double to, double max_step,
                       int start_values) {
  return support::trace_from_runs(scene, "forcing.frequency",
                                  {.from = from,
                                   .to = to,
                                   .max_step = max_step,
                                   .start_values = start_values,
                                   .follow_depth = 1});
}

double fastest(const Orbit& orbit, int stop) {
  double speed = 0.0;
  for (const OrbitImpact& impact : orbit.impacts)
    if (impact.stop == stop) speed = std::max(speed, impact.speed);
  return speed;
}

// Between its two doublings the orbit of scene 09 is unstable, and the doubled one is what the
// motion settles on.
TEST(StickingSwitch, DoubledOrbitsLeadFromDoublingToDoubling) {
  const Scene scene = support::shipped_scene("09_soft_stop_two_modes");
  const OrbitBranches result = followed(scene, 40.0, 40.6, 0.05, 8);
  ASSERT_EQ(result.branches.size(), 2u);
  const OrbitBranch& doubled = result.branches[1];
  EXPECT_EQ(doubled.pattern.period, 2);
  EXPECT_EQ(doubled.origin, "PD1");
  const auto doublings = support::special_points(result, SpecialKind::kPeriodDoubling);
  ASSERT_EQ(doublings.size(), 2u);
  for (const OrbitBranchEnd end : doubled.ends) EXPECT_EQ(end, OrbitBranchEnd::kPeriodDoubling);
  std::vector<double> ends = {doubled.points.front().value, doubled.points.back().value};
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(ends[i] / doublings[i]->at.value, 1.0, 1e-9);
  int compared = 0;
  for (std::size_t i = 0; i < doubled.points.size(); i += 2) {
    const OrbitBranchPoint& point = doubled.points[i];
    if (point.value < 40.2 || point.value > 40.4) continue;
    EXPECT_EQ(point.orbit.stable, true) << point.value;
    const Scene there = with_parameter(scene, "forcing.frequency", point.value);
    const System system = assemble(there);
    SimulationOptions options;
    options.periods = 600;
    double speed = 0.0;
    RunListeners listeners;
    listeners.event = [&](const Event& event) {
      if (event.kind == EventKind::kImpact && event.period_index >= 596)
        speed = std::max(speed, event.speed);
    };
    simulate(system, initial_state(there, system), options, listeners);
    EXPECT_NEAR(speed / fastest(point.orbit, 0), 1.0, 1e-8) << point.value;
    ++compared;
  }
  EXPECT_GE(compared, 2);
}

// Between two equal stops an orbit that is its own mirror image loses that at a branch point: the
// two that leave it meet one stop faster than the other.
TEST(StickingSwitch, BranchesThatCrossAreFoundFromEachOther) {
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [1.0, 5.18]\ndamping_ratios = [0.05, 0.05]\n"
      "participation = [1.0, 0.4]\n"
      "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = 0.65\n"
      "[[stop]]\nshape = [1.0, 1.33]\ngap = 0.05\nrestitution = 0.2\n"
      "[[stop]]\nshape = [1.0, 1.33]\ngap = 0.05\nside = \"below\"\nrestitution = 0.2\n",
      "between_stops.toml");
  const OrbitBranches result = followed(scene, 0.64, 0.75, 0.01, 8);
  ASSERT_EQ(result.branches.size(), 2u);
  const auto points = support::special_points(result, SpecialKind::kBranchPoint);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_NEAR(points[0]->at.value / points[1]->at.value, 1.0, 1e-10);
  EXPECT_EQ(result.branches[0].component, result.branches[1].component);
  int symmetric = 0;
  for (const OrbitBranch& branch : result.branches) {
    double most = 0.0;
    for (const OrbitBranchPoint& point : branch.points)
      most = std::max(most, std::abs(fastest(point.orbit, 0) / fastest(point.orbit, 1) - 1.0));
    // Beside the branch point unknowns are determined to kShootingAccuracy, 1e-7 of the motion, and
    // speeds are some part of it.
    symmetric += most < 1e-6;
    EXPECT_TRUE(most < 1e-6 || most > 1e-2) << most;
  }
  EXPECT_EQ(symmetric, 1);
  // From one start the second branch is found by the first.
  const OrbitBranches switched = followed(scene, 0.64, 0.75, 0.01, 0);
  ASSERT_EQ(switched.branches.size(), 2u);
  const auto named = [](const OrbitBranch& branch) { return branch.origin == "BP1"; };
  EXPECT_EQ(std::count_if(switched.branches.begin(), switched.branches.end(), named), 1);
  for (const OrbitBranch& branch : switched.branches)
    EXPECT_TRUE(
        std::any_of(branch.points.begin(), branch.points.end(), [&](const OrbitBranchPoint& point) {
          return std::abs(point.value / points[0]->at.value - 1.0) < 1e-10;
        }));
}

// The scene asks for less than the default: so does what a search along the way says of itself.
TEST(StickingBranch, ChattersAreClosedByTheScenesTolerance) {
  const Scene scene =
      read_scene(std::string(GRAZE_SOURCE_DIR) + "/data/scenes/09_soft_stop_two_modes.toml",
                 {"solver.tolerance=1e-6", "forcing.frequency=41.5"});
  const System system = assemble(scene);
  BranchOptions options;
  options.from = 41.4;
  options.to = 41.6;
  options.impacts = 64;  // none has so many: what is found is told in a note
  options.sticking = false;
  options.start_values = 0;
  options.finder.from_random = false;
  const OrbitBranches traced = trace_orbits(SystemFamily(scene, "forcing.frequency"), options);
  ASSERT_TRUE(traced.branches.empty());
  const double speed =
      default_closure_speed(system, initial_state(scene, system), scene.solver.tolerance);
  char words[64];
  std::snprintf(words, sizeof words, "closure speed of its chatters is %.4g m/s", speed);
  EXPECT_TRUE(
      std::any_of(traced.details.begin(), traced.details.end(),
                  [&](const std::string& note) { return note.find(words) != std::string::npos; }))
      << words << " in: " << (traced.details.empty() ? "" : traced.details.front());
}

}  // namespace
}  // namespace graze
