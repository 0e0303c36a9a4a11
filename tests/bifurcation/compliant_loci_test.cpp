// Loci of orbits on compliant stops.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "branch_checks.hpp"
#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/bifurcation/loci/restart.hpp"
#include "graze/orbit/problem/detail/followed_orbit.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/scene/parameter.hpp"

namespace graze {
namespace {

LociOptions options_of(double from, double to, double second_from, double second_to) {
  LociOptions options;
  options.branches.from = from;
  options.branches.to = to;
  options.branches.start_values = 2;
  options.branches.finder.from_random = false;
  options.second_from = second_from;
  options.second_to = second_to;
  options.kinds = {OrbitLocusKind::kPeriodDoubling};
  options.slices = 1;
  return options;
}

// With a linear spring and a dashpot nothing changes but the size when gap and force grow together:
// a locus over both is a straight line through the origin.
TEST(CompliantLoci, OfALinearSpringAreRaysInGapAndForce) {
  const Scene scene =
      support::shipped_scene("12_spring_dashpot_oscillator", {"forcing.frequency=2.5"});
  const OrbitLoci result =
      trace_loci(scene, "stop.gap", "forcing.amplitude", options_of(-0.1, 0.15, 0.5, 2.0));
  ASSERT_EQ(result.loci.size(), 1u);
  const OrbitLocus& locus = result.loci.front();
  EXPECT_GT(locus.points.size(), 10u);
  const double slope = locus.points.front().value / locus.points.front().second;
  EXPECT_GT(slope, 0.01);
  for (const OrbitLocusPoint& point : locus.points)
    EXPECT_NEAR(point.value / point.second, slope, 1e-10);
  EXPECT_EQ(locus.ends[0], OrbitLocusEnd::kSecondLimit);
  EXPECT_EQ(locus.ends[1], OrbitLocusEnd::kSecondLimit);
}

// At its points the orbit that is solved for there has the multiplier -1, whatever the law.
TEST(CompliantLoci, HaveTheCriticalMultiplier) {
  const Scene scene = support::shipped_scene(
      "12_spring_dashpot_oscillator",
      {"forcing.frequency=2.5", "stop.gap=0.0",
       "stop.spring={stiffness=900.0,exponent=1.5,damping={model=\"hunt-crossley\",alpha=0.3}}"});
  const OrbitLoci result = trace_loci(scene, "forcing.frequency", "stop.spring.stiffness",
                                      options_of(2.3, 2.9, 500.0, 2000.0));
  ASSERT_EQ(result.loci.size(), 1u);
  const OrbitLocus& locus = result.loci.front();
  ASSERT_GT(locus.points.size(), 10u);
  for (std::size_t i = 0; i < locus.points.size(); i += 12) {
    const OrbitLocusPoint& point = locus.points[i];
    const Scene there = with_parameter(with_parameter(scene, "forcing.frequency", point.value),
                                       "stop.spring.stiffness", point.second);
    const System system = assemble(there);
    FinderOptions options;
    options.from_simulation = false;
    const FoundOrbits found = find_orbits(system, {}, options);
    double nearest = 1.0;
    for (const Orbit& orbit : found.orbits)
      for (const Eigenvalue& multiplier : orbit.multipliers)
        nearest = std::min(nearest, std::abs(multiplier.value + 1.0));
    EXPECT_LT(nearest, 1e-8) << point.value << " " << point.second;
  }
}

LociOptions grazing_options(double from, double to, double second_from, double second_to) {
  LociOptions options = options_of(from, to, second_from, second_to);
  options.kinds = {OrbitLocusKind::kGrazing};
  return options;
}

// An orbit that only touches is the response that meets no stop, so it touches where the gap is the
// amplitude of that, F/sqrt((w0^2 - w^2)^2 + (2 zeta w0 w)^2), whatever the law of the stop.
TEST(CompliantLoci, OfGrazingAloneAreWhereTheResponseIsAsLargeAsTheGap) {
  for (const char* law :
       {"stiffness=400.0,exponent=1.5,damping={model=\"hunt-crossley\",alpha=0.6}",
        "stiffness=400.0,exponent=1.0,damping={model=\"kelvin-voigt\",coefficient=2.8}"}) {
    const Scene scene = support::shipped_scene(
        "12_spring_dashpot_oscillator",
        {"forcing.frequency=2.4", "stop.gap=0.7", std::string("stop.spring={") + law + "}"});
    LociOptions options = grazing_options(0.0, 0.6, 2.0, 3.0);
    options.slices = 0;
    const OrbitLoci result = trace_loci(scene, "stop.gap", "forcing.frequency", options);
    ASSERT_EQ(result.loci.size(), 1u) << law;
    const OrbitLocus& locus = result.loci.front();
    EXPECT_EQ(locus.pattern.period, 1);
    EXPECT_EQ(locus.pattern.stops, std::vector<int>{0});
    EXPECT_EQ(locus.ends[0], OrbitLocusEnd::kSecondLimit);
    EXPECT_EQ(locus.ends[1], OrbitLocusEnd::kSecondLimit);
    ASSERT_GT(locus.points.size(), 20u);
    for (const OrbitLocusPoint& point : locus.points) {
      const double w = point.second;
      EXPECT_NEAR(point.value, 1.0 / std::hypot(1.0 - w * w, 0.1 * w), 1e-11) << w;
      ASSERT_EQ(point.impacts.size(), 1u);
      EXPECT_EQ(point.impacts.front().speed, 0.0);
      // As far into the forcing's turn as the response lags behind it.
      EXPECT_NEAR(std::remainder(point.impacts.front().phase - std::atan2(0.1 * w, 1.0 - w * w),
                                 2.0 * std::acos(-1.0)),
                  0.0, 1e-9);
    }
  }
}

// A special point of a locus keeps its orbit as states; from there the same locus is traced again.
TEST(CompliantLoci, GoOnFromTheirSpecialPoints) {
  const Scene scene = support::shipped_scene("12_spring_dashpot_oscillator",
                                             {"forcing.frequency=2.4", "stop.gap=0.7"});
  LociOptions options = grazing_options(0.0, 0.6, 2.3, 2.5);
  options.slices = 0;
  OrbitLoci traced = trace_loci(scene, "stop.gap", "forcing.frequency", options);
  ASSERT_EQ(traced.loci.size(), 1u);
  OrbitLocus& locus = traced.loci.front();
  const OrbitLocusPoint at = locus.points[locus.points.size() / 3];
  locus.special.push_back({"GRGR", "GRGR-1", at});
  const std::vector<SpecialOrbit> special = special_orbits(traced);
  ASSERT_EQ(special.size(), 1u);
  EXPECT_EQ(special[0].locus, OrbitLocusKind::kGrazing);
  ASSERT_TRUE(special[0].followed);
  ASSERT_EQ(special[0].followed->states.size(), 1u);
  // The response F cos(w t - lag) at the start of its forcing period.
  const double w = at.second, re = 1.0 - w * w, im = 0.1 * w, size = re * re + im * im;
  EXPECT_NEAR(special[0].followed->states[0].q[0], re / size, 1e-9);
  EXPECT_NEAR(special[0].followed->states[0].qdot[0], w * im / size, 1e-9);
  options.start = locus_start(assemble(scene), special[0], at.value, at.second);
  ASSERT_TRUE(options.start);
  const OrbitLoci again = trace_loci(scene, "stop.gap", "forcing.frequency", options);
  ASSERT_EQ(again.loci.size(), 1u);
  EXPECT_EQ(again.slices, 0);
  for (const OrbitLocusPoint& point : again.loci[0].points)
    EXPECT_NEAR(point.value,
                1.0 / std::hypot(1.0 - point.second * point.second, 0.1 * point.second), 1e-11);
  EXPECT_NEAR(again.loci[0].points.front().second, locus.points.front().second, 1e-12);
  EXPECT_NEAR(again.loci[0].points.back().second, locus.points.back().second, 1e-12);
}

int contacts_at(const Scene& scene, const OrbitLocusPoint& point, double gap) {
  const System system = assemble(
      with_parameter(with_parameter(with_parameter(scene, "forcing.frequency", point.value),
                                    "stop.spring.damping.alpha", point.second),
                     "stop.gap", gap));
  const std::vector<MotionState<double>>& turns = point.section->states;
  const FollowedAnswer answer = followed_orbit(system, {turns.front().q, turns.front().qdot},
                                               static_cast<int>(turns.size()), SegmentOptions{});
  EXPECT_TRUE(answer.orbit) << answer.why_not;
  return answer.orbit ? static_cast<int>(answer.orbit->impacts.size()) : 0;
}

// Of an orbit with another contact: there the doubled orbit gains one or loses one, as the gap
// moves by a millionth either way.
TEST(CompliantLoci, OfGrazingAreWhereContactsAreBorn) {
  const Scene scene = support::shipped_scene(
      "12_spring_dashpot_oscillator",
      {"forcing.frequency=2.4", "stop.gap=0.0",
       "stop.spring={stiffness=400.0,exponent=1.0,damping={model=\"hunt-crossley\",alpha=0.6}}"});
  LociOptions options = grazing_options(2.5, 3.2, 0.55, 0.65);
  options.slices = 0;
  options.branches.follow_depth = 1;
  const OrbitLoci result =
      trace_loci(scene, "forcing.frequency", "stop.spring.damping.alpha", options);
  ASSERT_EQ(result.loci.size(), 1u);
  const OrbitLocus& locus = result.loci.front();
  EXPECT_EQ(locus.pattern.period, 2);
  EXPECT_EQ(locus.pattern.stops, (std::vector<int>{0, 0}));
  ASSERT_GT(locus.points.size(), 20u);
  for (std::size_t i = 0; i < locus.points.size(); i += 16) {
    const OrbitLocusPoint& point = locus.points[i];
    ASSERT_EQ(point.impacts.size(), 2u);
    const int below = contacts_at(scene, point, -1e-6), above = contacts_at(scene, point, 1e-6);
    EXPECT_EQ(std::min(below, above), 1) << point.value << " " << point.second;
    EXPECT_EQ(std::max(below, above), 2) << point.value << " " << point.second;
  }
}

}  // namespace
}  // namespace graze
