// Grazings of orbits that stick, on branches whose equations do not see them and in pairs within
// one step, against runs on either side and against shorter steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "branch_checks.hpp"
#include "graze/bifurcation/cut/detail/release_boundaries.hpp"
#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/flow/exact/detail/exact_flow.hpp"
#include "graze/orbit/problem/detail/laid_orbit.hpp"
#include "graze/scene/parameter.hpp"

namespace graze {
namespace {

using support::special_points;
using support::sticking_branches;

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
    const OrbitBranches result =
        sticking_branches(scene, "forcing.frequency", {.from = 0.3, .to = 0.58, .start_values = 8});
    ASSERT_EQ(result.branches.size(), 1u);
    EXPECT_EQ(result.branches[0].ends[0], OrbitBranchEnd::kParameterLimit);
    EXPECT_EQ(result.branches[0].ends[1], OrbitBranchEnd::kParameterLimit);
    const auto grazings = special_points(result, SpecialKind::kGrazing);
    ASSERT_EQ(grazings.size(), 1u) << gap;
    EXPECT_NEAR(grazings[0]->at.value / touching, 1.0, 1e-12);
    EXPECT_EQ(grazings[0]->id, "GR1");
  }
}

// In the plane of two parameters, by the same closed form at every point: N = m, and the impact
// that just touches is on another stop than the chatter.
TEST(StickingGrazing, HasALocusOverTwoParameters) {
  const Scene scene = two_sided(1.6);
  LociOptions options;
  options.branches.from = 0.3;
  options.branches.to = 0.58;
  options.branches.start_values = 8;
  options.second_from = 1.3;
  options.second_to = 1.8;
  options.kinds = {OrbitLocusKind::kGrazing};
  options.slices = 1;
  const OrbitLoci result = trace_loci(scene, "forcing.frequency", "stop.2.gap", options);
  ASSERT_EQ(result.loci.size(), 1u);
  const OrbitLocus& locus = result.loci[0];
  EXPECT_TRUE(locus.sticks());
  ASSERT_GE(locus.points.size(), 50u);
  const SystemFamily family(scene, "forcing.frequency");
  for (const OrbitLocusPoint& point : locus.points) {
    EXPECT_NEAR(reach(*family.at(point.value)) / point.second, 1.0, 1e-12) << point.value;
    EXPECT_EQ(std::ranges::count(point.impacts, 1, &OrbitImpact::stop), 1);
  }
}

// Between 0.1245285 and 0.1246259 rad/s an approach touches twice: the step is 0.012.
TEST(StickingGrazing, PairsWithinAStepArePassedOneByOne) {
  const Scene scene = two_sided(1.02);
  const SystemFamily family(scene, "forcing.frequency");
  std::vector<std::vector<double>> found;
  for (const double step : {0.0, 0.0005}) {
    const OrbitBranches result = sticking_branches(
        scene, "forcing.frequency", {.from = 0.1, .to = 0.7, .max_step = step, .start_values = 8});
    found.emplace_back();
    for (const SpecialPoint* special : special_points(result, SpecialKind::kGrazing))
      found.back().push_back(special->at.value);
  }
  EXPECT_EQ(found[0].size(), 6u);
  ASSERT_EQ(found[0].size(), found[1].size());
  for (std::size_t i = 0; i < found[0].size(); ++i) {
    EXPECT_NEAR(found[0][i] / found[1][i], 1.0, 1e-9);
    const auto impacts = [&](double side) {
      return support::events_a_period(family, found[0][i] * (1.0 + side * 1e-8), EventKind::kImpact,
                                      20);
    };
    EXPECT_NE(impacts(-1.0), impacts(1.0)) << found[0][i];
  }
}

// At gap 0 and without a load all motion goes with the amplitude, and nothing grazes. A release
// there may be followed by an impact that is rounding, some 1e-32 m/s.
TEST(StickingGrazing, IsNothingThatRoundingMakes) {
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.019]\nparticipation = [0.596]\n"
      "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = 0.7945\n"
      "[[stop]]\nshape = [0.616]\ngap = 0.0\nrestitution = 0.0\n",
      "no_gap.toml");
  for (const double step : {0.0, 0.004}) {
    const OrbitBranches result = sticking_branches(
        scene, "forcing.amplitude", {.from = 0.6, .to = 1.6, .max_step = step, .start_values = 4});
    ASSERT_EQ(result.branches.size(), 1u);
    EXPECT_TRUE(result.branches[0].special.empty()) << result.branches[0].special.size();
  }
}

// Beyond CH the impacts of the chatter that does not complete any more vanish one after the other.
TEST(StickingGrazing, RowsBesideAChatterPointDoNotDependOnTheSteps) {
  std::vector<std::vector<double>> found;
  for (const double step : {0.0, 0.001}) {
    const OrbitBranches result =
        sticking_branches(two_sided(0.9), "forcing.frequency",
                          {.from = 0.1, .to = 0.4, .max_step = step, .start_values = 4});
    found.emplace_back();
    for (const SpecialPoint* special : special_points(result, SpecialKind::kGrazing))
      found.back().push_back(special->at.value);
  }
  EXPECT_GE(found[0].size(), 20u);
  ASSERT_EQ(found[0].size(), found[1].size());
  for (std::size_t i = 0; i < found[0].size(); ++i)
    EXPECT_NEAR(found[0][i] / found[1][i], 1.0, 1e-10);
}

// ---------------------------------------------------------------- several modes

// Two modes that stick on one stop and swing past a second one, which a gap of 3 m keeps clear.
Scene two_modes(double gap) {
  Scene scene = parse_scene(
      "[modal]\nfrequencies = [1.0, 3.3]\ndamping_ratios = [0.02, 0.02]\n"
      "participation = [1.0, 0.4]\n"
      "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = 0.4795\n"
      "[[stop]]\nshape = [1.0, 0.8]\ngap = 0.1\nrestitution = 0.4\n"
      "[[stop]]\nshape = [1.0, -1.5]\ngap = 3.0\nside = \"below\"\nrestitution = 0.4\n",
      "two_modes.toml");
  return with_parameter(scene, "stop.2.gap", gap);
}

// How near the motion of a solution comes to the second stop, sampled and refined, less `gap`.
double excess(const SegmentEquations& equations, const SolutionPoint& at, double gap) {
  const System& system = *equations.system_at(at.parameter);
  const SegmentShooting& shooting = equations.shooting();
  const MotionState<double> start =
      *equations.map().start_of(system, shooting.at_section(at.u, 0), shooting.theta_of(at.u));
  SegmentOptions options;
  options.closure_speed = 1e-8;
  double farthest = -1.0;
  options.flight = [&](const ContactPhase<double>& phase, const Instant<double>&, double length) {
    Vector q(2), qdot(2);
    const auto reach = [&](double s) {
      phase.state(s, q, qdot);
      return system.stops[1].row.dot(q);
    };
    const int samples = std::max(4, static_cast<int>(length / 0.02));
    for (int i = 1; i < samples; ++i) {
      double low = length * (i - 1) / samples, high = length * (i + 1) / samples;
      const double here = reach(length * i / samples);
      if (!(here >= reach(low) && here >= reach(high))) continue;
      for (int k = 0; k < 80; ++k) {
        const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
        (reach(a) < reach(b) ? low : high) = reach(a) < reach(b) ? a : b;
      }
      farthest = std::max(farthest, reach(low));
    }
  };
  pass(system, start, {1, start.instant.local}, options);
  return farthest - gap;
}

// The approach to the second stop touches at two places of a branch; between them there is no such
// orbit, on either side of both there is. A step may lead across both.
TEST(StickingGrazing, PairsBetweenOrbitsWithTheSameEventsAreSeen) {
  const double gap = 1.5185, low = 0.4792, middle = 0.4805, high = 0.4825;
  const SystemFamily clear(two_modes(3.0), "forcing.frequency"),
      near(two_modes(gap), "forcing.frequency");
  const OrbitBranches result = sticking_branches(clear.scene(), "forcing.frequency",
                                                 {.from = 0.4785, .to = 0.4835, .start_values = 1});
  ASSERT_FALSE(result.branches.empty());
  const OrbitBranchPoint& point = result.branches[0].points.front();
  const SegmentOptions options{point.orbit.section->closure_speed, 10'000'000, {}};
  const System system = *clear.at(point.value);
  const LaidOrbit start = layouts_of(system, point.orbit, options).front();
  const auto equations_of = [&](const SystemFamily& family) {
    return std::make_unique<SegmentEquations>(family.scene(), std::vector{family.parameter()},
                                              std::vector{0.005}, system, start.layout, options);
  };
  const auto clear_equations = equations_of(clear), near_equations = equations_of(near);
  const SegmentEquations &without = *clear_equations, &equations = *near_equations;
  ContinuationOptions range;
  range.from = 0.4785;
  range.to = 0.4835;
  // Orbits that the second stop does not touch, at fixed values.
  Vector u = without.shooting().pack(system, start.theta, start.states);
  double value = point.value;
  const auto at = [&](double next) {
    std::optional<SolutionPoint> solution;
    const int steps = 1 + static_cast<int>(std::abs(next - value) / 1e-4);
    for (int i = 1; i <= steps; ++i) {
      solution = solve_at(without.problem(), range, u, value + (next - value) * i / steps);
      u = solution.value().u;
    }
    value = next;
    return *solution;
  };
  const SolutionPoint a = at(low), b = at(high);
  ASSERT_LT(excess(without, a, gap), 0.0);
  ASSERT_LT(excess(without, b, gap), 0.0);
  ASSERT_GT(excess(without, at(middle), gap), 0.0);
  ReleaseBoundaries boundaries(equations, range);
  EXPECT_FALSE(boundaries.goes_on(a, b));
  for (const bool from_left : {true, false}) {
    double outside = from_left ? low : high, inside = middle;
    for (int i = 0; i < 45; ++i) {
      const double half = 0.5 * (outside + inside);
      (excess(without, at(half), gap) > 0.0 ? inside : outside) = half;
    }
    Branch step;
    step.points = {a, b};
    step.ends = {BranchEnd::kHalted, BranchEnd::kHalted};
    const std::optional<BranchTip> tip = boundaries.close(step, from_left ? 1 : 0);
    ASSERT_TRUE(tip && tip->place && tip->place->special);
    EXPECT_EQ(tip->end, OrbitBranchEnd::kGrazing);
    EXPECT_FALSE(tip->place->special->by_speed);
    EXPECT_NEAR(tip->place->at.value / outside, 1.0, 1e-9);
  }
  // Where the stop is a little farther away there is nothing between.
  const SystemFamily beyond(two_modes(1.5188), "forcing.frequency");
  const auto untouched = equations_of(beyond);
  ReleaseBoundaries none(*untouched, range);
  EXPECT_TRUE(none.goes_on(a, b));
}

}  // namespace
}  // namespace graze
