// Loci of orbits on compliant stops.
#include <gtest/gtest.h>

#include <cmath>

#include "branch_checks.hpp"
#include "graze/bifurcation/orbit_loci.hpp"
#include "graze/orbit/strobe_orbit.hpp"
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
TEST(StrobeLoci, OfALinearSpringAreRaysInGapAndForce) {
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
TEST(StrobeLoci, HaveTheCriticalMultiplier) {
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

}  // namespace
}  // namespace graze
