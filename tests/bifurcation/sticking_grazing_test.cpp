// Grazings of orbits that stick, on branches whose equations do not see them and in pairs within
// one step, against runs on either side and against shorter steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "branch_checks.hpp"
#include "graze/flow/exact_flow.hpp"
#include "graze/hybrid/simulation.hpp"
#include "graze/scene/parameter.hpp"

namespace graze {
namespace {

using support::special_points;

OrbitBranches traced(const Scene& scene, const std::string& parameter, double from, double to,
                     double max_step = 0.0, int start_values = 8) {
  const SystemFamily family(scene, parameter);
  BranchOptions options;
  options.max_step = max_step;
  options.from = from;
  options.to = to;
  options.start_values = start_values;
  options.finder.from_closed_form = options.finder.from_random = false;
  OrbitBranches result = trace_orbits(family, options);
  const auto bounces = [](const OrbitBranch& branch) { return !branch.sticks(); };
  result.branches.erase(std::remove_if(result.branches.begin(), result.branches.end(), bounces),
                        result.branches.end());
  return result;
}

// An oscillator that sticks at a gap of 0.2, where the push F cos(theta) - q sets it free, and
// swings over to a second stop.
Scene two_sided(double gap) {
  Scene scene = parse_scene(
      "[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.05]\nparticipation = [1.0]\n"
      "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = 0.4\n"
      "[[stop]]\nshape = [1.0]\ngap = 0.2\nrestitution = 0.4\n"
      "[[stop]]\nshape = [1.0]\ngap = 1.4\nside = \"below\"\nrestitution = 0.4\n",
      "two_sided.toml");
  return with_parameter(scene, "stop.2.gap", gap);
}

// How far an oscillator swings from the first stop after its release, m.
double reach(const System& system) {
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  arc.start(std::acos(0.2), Vector::Constant(1, 0.2), Vector::Zero(1));
  Vector q(1), qdot(1);
  double low = 0.0, high = 0.0;
  const auto rate = [&](double s) {
    arc.state(s, q, qdot);
    return qdot[0];
  };
  // Its first turning point.
  for (double s = 1e-2; high == 0.0; s += 1e-2) (rate(s) < 0.0 ? low : high) = s;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (rate(middle) < 0.0 ? low : high) = middle;
  }
  arc.state(low, q, qdot);
  return -q[0];
}

// With N = m the branch goes on: nothing in its equations feels the grazing.
TEST(StickingGrazing, IsASpecialPointWhereAllDirectionsAreHeld) {
  for (const double gap : {1.4, 1.6, 1.7}) {
    const Scene scene = two_sided(gap);
    const SystemFamily family(scene, "forcing.frequency");
    double touching = 0.3, clear = 0.58;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (touching + clear);
      (reach(*family.at(middle)) > gap ? clear : touching) = middle;
    }
    const OrbitBranches result = traced(scene, "forcing.frequency", 0.3, 0.58);
    ASSERT_EQ(result.branches.size(), 1u);
    EXPECT_EQ(result.branches[0].ends[0], OrbitBranchEnd::kParameterLimit);
    EXPECT_EQ(result.branches[0].ends[1], OrbitBranchEnd::kParameterLimit);
    const auto grazings = special_points(result, SpecialKind::kGrazing);
    ASSERT_EQ(grazings.size(), 1u) << gap;
    EXPECT_NEAR(grazings[0]->at.value / touching, 1.0, 1e-12);
    EXPECT_EQ(grazings[0]->id, "GR1");
  }
}

// Impacts in each of the last periods of a run.
double impacts_a_period(const SystemFamily& family, double value) {
  const System system = *family.at(value);
  const Scene scene = with_parameter(family.scene(), family.parameter(), value);
  SimulationOptions options;
  options.periods = 40;
  int impacts = 0;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    impacts += event.kind == EventKind::kImpact && event.period_index >= 20;
  };
  simulate(system, initial_state(scene, system), options, listeners);
  return impacts / 20.0;
}

// Between 0.1245285 and 0.1246259 rad/s an approach touches twice: the step is 0.012.
TEST(StickingGrazing, PairsWithinAStepArePassedOneByOne) {
  const Scene scene = two_sided(1.02);
  const SystemFamily family(scene, "forcing.frequency");
  std::vector<std::vector<double>> found;
  for (const double step : {0.0, 0.0005}) {
    const OrbitBranches result = traced(scene, "forcing.frequency", 0.1, 0.7, step);
    found.emplace_back();
    for (const SpecialPoint* special : special_points(result, SpecialKind::kGrazing))
      found.back().push_back(special->at.value);
  }
  EXPECT_EQ(found[0].size(), 6u);
  ASSERT_EQ(found[0].size(), found[1].size());
  for (std::size_t i = 0; i < found[0].size(); ++i) {
    EXPECT_NEAR(found[0][i] / found[1][i], 1.0, 1e-9);
    const double before = impacts_a_period(family, found[0][i] * (1.0 - 1e-8)),
                 behind = impacts_a_period(family, found[0][i] * (1.0 + 1e-8));
    EXPECT_NE(before, behind) << found[0][i];
  }
}

}  // namespace
}  // namespace graze
