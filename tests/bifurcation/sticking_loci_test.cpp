// Loci of orbits that stick: folds, doublings and tori against the special points of branches over
// one parameter, value by value of the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "branch_checks.hpp"
#include "graze/bifurcation/orbit_loci.hpp"
#include "graze/scene/parameter.hpp"

namespace graze {
namespace {

struct Plane {
  const char* name;
  Scene scene;
  const char *first, *second;
  OrbitLocusKind kind;
  SpecialKind special;
  double from, to, second_from, second_to;
  double max_step = 0.0;
};

// Names tests.
void PrintTo(const Plane& plane, std::ostream* out) { *out << plane.name; }

class StickingLoci : public ::testing::TestWithParam<Plane> {};

// The first parameter where a locus has a value of the second, by the branch over the first there,
// from the orbit of the nearest point.
TEST_P(StickingLoci, PassTheSpecialPointsOfTenSlices) {
  const Plane& plane = GetParam();
  LociOptions options;
  options.branches.from = plane.from;
  options.branches.to = plane.to;
  options.branches.max_step = plane.max_step;
  options.branches.start_values = 1;
  options.branches.finder.from_closed_form = options.branches.finder.from_random = false;
  options.second_from = plane.second_from;
  options.second_to = plane.second_to;
  options.kinds = {plane.kind};
  options.slices = 0;
  const OrbitLoci result = trace_loci(plane.scene, plane.first, plane.second, options);
  const auto sticks = [](const OrbitLocus& locus) {
    return !locus.points.empty() && !locus.points.front().holds.empty();
  };
  const auto found = std::find_if(result.loci.begin(), result.loci.end(), sticks);
  ASSERT_NE(found, result.loci.end()) << result.starts << " starts, " << result.lost_starts;
  const std::vector<OrbitLocusPoint>& points = found->points;
  ASSERT_GE(points.size(), 10u);
  int compared = 0;
  for (int i = 0; i < 10; ++i) {
    const OrbitLocusPoint& point = points[points.size() * static_cast<std::size_t>(2 * i + 1) / 20];
    SCOPED_TRACE(std::to_string(point.value) + ", " + std::to_string(point.second));
    const Scene there = with_parameter(plane.scene, plane.second, point.second);
    const SystemFamily family(there, plane.first);
    BranchOptions slice;
    const double reach = 0.02 * (plane.to - plane.from);
    slice.from = std::max(plane.from, point.value - reach);
    slice.to = std::min(plane.to, point.value + reach);
    slice.max_step = plane.max_step;
    SpecialOrbit at;
    at.kind = plane.special;
    at.label = label_of(plane.kind);
    at.followed = SpecialOrbit::Followed{found->pattern.period, point.value, point.section->states,
                                         point.section->closure_speed};
    slice.start = BranchStart{at, false, false};
    const OrbitBranches traced = trace_orbits(
        SystemFamily(with_parameter(there, plane.first, point.value), plane.first), slice);
    double nearest = 1.0;
    for (const OrbitBranch& branch : traced.branches)
      for (const SpecialPoint& special : branch.special)
        if (special.kind == plane.special)
          nearest = std::min(nearest, std::abs(special.at.value / point.value - 1.0));
    EXPECT_LE(nearest, 1e-9) << traced.branches.size();
    ++compared;
  }
  EXPECT_EQ(compared, 10);
}

struct CompletionPlane {
  const char* name;
  Scene scene;
  const char *first, *second;
  double from, to, second_from, second_to;
};

// Names tests.
void PrintTo(const CompletionPlane& plane, std::ostream* out) { *out << plane.name; }

class CompletionLoci : public ::testing::TestWithParam<CompletionPlane> {};

// Where branches over one parameter end with CH, bisected between orbits that stick and solutions
// that do not.
TEST_P(CompletionLoci, PassTheEndsOfTenBranches) {
  const CompletionPlane& plane = GetParam();
  LociOptions options;
  options.branches.from = plane.from;
  options.branches.to = plane.to;
  options.branches.start_values = 2;
  options.branches.finder.from_closed_form = options.branches.finder.from_random = false;
  options.second_from = plane.second_from;
  options.second_to = plane.second_to;
  options.kinds = {OrbitLocusKind::kChatterCompletes};
  options.slices = 0;
  const OrbitLoci result = trace_loci(plane.scene, plane.first, plane.second, options);
  ASSERT_FALSE(result.loci.empty()) << result.starts << " starts, " << result.lost_starts;
  const std::vector<OrbitLocusPoint>& points = result.loci.front().points;
  ASSERT_GE(points.size(), 10u);
  for (int i = 0; i < 10; ++i) {
    const OrbitLocusPoint& point = points[points.size() * static_cast<std::size_t>(2 * i + 1) / 20];
    SCOPED_TRACE(std::to_string(point.value) + ", " + std::to_string(point.second));
    const double reach = 0.05 * (plane.to - plane.from);
    const OrbitBranches traced = support::sticking_branches(
        with_parameter(with_parameter(plane.scene, plane.second, point.second), plane.first,
                       point.value - 0.5 * reach),
        plane.first, {.from = point.value - reach, .to = point.value + reach, .start_values = 2});
    double nearest = 1.0;
    for (const OrbitBranch& branch : traced.branches)
      for (const SpecialPoint& special : branch.special)
        if (special.kind == SpecialKind::kChatterCompletes)
          nearest = std::min(nearest, std::abs(special.at.value / point.value - 1.0));
    EXPECT_LE(nearest, 1e-8) << traced.branches.size();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Planes, CompletionLoci,
    ::testing::Values(
        CompletionPlane{"soft stop, lower end", support::shipped_scene("09_soft_stop_two_modes"),
                        "forcing.frequency", "stop.restitution", 36.8, 37.8, 0.2, 0.4},
        CompletionPlane{"soft stop, upper end", support::shipped_scene("09_soft_stop_two_modes"),
                        "forcing.frequency", "stop.gap", 41.5, 42.1, 0.00095, 0.0012}));

INSTANTIATE_TEST_SUITE_P(
    Planes, StickingLoci,
    ::testing::Values(
        Plane{"torus of the soft stop",
              support::shipped_scene("09_soft_stop_two_modes", {"forcing.frequency=38.2"}),
              "forcing.frequency", "stop.restitution", OrbitLocusKind::kTorus, SpecialKind::kTorus,
              37.4, 38.8, 0.15, 0.35, 0.05},
        Plane{"doubling of the soft stop",
              support::shipped_scene("09_soft_stop_two_modes", {"forcing.frequency=40.6"}),
              "forcing.frequency", "stop.restitution", OrbitLocusKind::kPeriodDoubling,
              SpecialKind::kPeriodDoubling, 40.2, 41.0, 0.15, 0.35, 0.05}));

}  // namespace
}  // namespace graze
