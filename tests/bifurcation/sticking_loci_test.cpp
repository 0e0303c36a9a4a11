// Loci of orbits that stick: folds, doublings and tori against the special points of branches over
// one parameter, value by value of the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "branch_checks.hpp"
#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/orbit/problem/detail/chatter_completion.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// Two modes and a stop, drawn by lot.
Scene drawn(double second_frequency, double damping, double second_damping, double load,
            double second_load, double shape, double second_shape, double gap, double frequency) {
  Scene scene = parse_scene(
      "[modal]\nfrequencies = [1.0, 5.0]\ndamping_ratios = [0.1, 0.1]\n"
      "participation = [1.0, 1.0]\n"
      "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = 0.6\n"
      "[[stop]]\nshape = [1.0, 1.0]\ngap = 0.3\nrestitution = 0.36\n",
      "drawn.toml");
  for (const auto& [key, value] :
       std::vector<std::pair<const char*, double>>{{"modal.frequencies.2", second_frequency},
                                                   {"modal.damping_ratios.1", damping},
                                                   {"modal.damping_ratios.2", second_damping},
                                                   {"modal.participation.1", load},
                                                   {"modal.participation.2", second_load},
                                                   {"stop.shape.1", shape},
                                                   {"stop.shape.2", second_shape},
                                                   {"stop.gap", gap},
                                                   {"forcing.frequency", frequency}})
    scene = with_parameter(scene, key, value);
  return scene;
}

Scene first_drawn(double frequency) {
  return drawn(5.192, 0.082, 0.065, 0.445, 0.449, 0.908, 0.928, 0.284, frequency);
}
Scene second_drawn(double frequency) {
  return drawn(6.042, 0.072, 0.037, 0.919, 0.592, 0.626, -0.721, 0.256, frequency);
}

Scene two_modes() {
  return parse_scene(
      "[modal]\nfrequencies = [1.0, 3.3]\ndamping_ratios = [0.02, 0.02]\n"
      "participation = [1.0, 0.4]\n"
      "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = 0.45\n"
      "[[stop]]\nshape = [1.0, 0.8]\ngap = 0.1\nrestitution = 0.4\n",
      "two_modes.toml");
}

// Of loci in a plane, from the branches at the scene's own values, which start from simulations.
template <class InPlane>
LociOptions options_of(const InPlane& plane, OrbitLocusKind kind, int start_values) {
  LociOptions options;
  options.branches.from = plane.from;
  options.branches.to = plane.to;
  options.branches.start_values = start_values;
  options.branches.finder.from_closed_form = options.branches.finder.from_random = false;
  options.second_from = plane.second_from;
  options.second_to = plane.second_to;
  options.kinds = {kind};
  options.slices = 0;
  return options;
}

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

// Which of ten places along a locus are looked at: four, all where GRAZE_LONG is set, as
// tests/long.sh does.
std::vector<std::size_t> places_of_ten() {
  if (std::getenv("GRAZE_LONG")) return {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  return {0, 3, 6, 9};
}

class StickingLoci : public ::testing::TestWithParam<Plane> {};

// The first parameter where a locus has a value of the second, by the branch over the first there,
// from the orbit of the nearest point.
TEST_P(StickingLoci, PassTheSpecialPointsOfSlices) {
  const Plane& plane = GetParam();
  LociOptions options = options_of(plane, plane.kind, 1);
  options.branches.max_step = plane.max_step;
  const OrbitLoci result = trace_loci(plane.scene, plane.first, plane.second, options);
  const auto found = std::find_if(result.loci.begin(), result.loci.end(),
                                  [](const OrbitLocus& locus) { return locus.sticks(); });
  ASSERT_NE(found, result.loci.end()) << result.starts << " starts, " << result.lost_starts;
  const std::vector<OrbitLocusPoint>& points = found->points;
  ASSERT_GE(points.size(), 10u);
  for (const std::size_t i : places_of_ten()) {
    const OrbitLocusPoint& point = points[points.size() * (2 * i + 1) / 20];
    SCOPED_TRACE(std::to_string(point.value) + ", " + std::to_string(point.second));
    const Scene there = with_parameter(plane.scene, plane.second, point.second);
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
    OrbitBranches traced;
    if (plane.special == SpecialKind::kPeriodDoubling || plane.special == SpecialKind::kTorus) {
      slice.start = BranchStart{at, false, false};
      traced = trace_orbits(
          SystemFamily(with_parameter(there, plane.first, point.value), plane.first), slice);
    } else {
      // From a fold itself a branch leads away on both sides of it, and at a grazing it has a
      // corner.
      const double wide = plane.special == SpecialKind::kFold ? 1.0 : 0.1;
      slice.start_values = 6;
      slice.from = std::max(plane.from, point.value - wide * (plane.to - plane.from));
      slice.to = std::min(plane.to, point.value + wide * (plane.to - plane.from));
      traced = support::sticking_branches(there, plane.first, slice);
    }
    double nearest = 1.0;
    for (const OrbitBranch& branch : traced.branches)
      for (const SpecialPoint& special : branch.special)
        if (special.kind == plane.special)
          nearest = std::min(nearest, std::abs(special.at.value / point.value - 1.0));
    EXPECT_LE(nearest, 1e-9) << traced.branches.size();
  }
}

struct CompletionPlane {
  const char* name;
  Scene scene;
  const char *first, *second;
  double from, to, second_from, second_to;
};

// Names tests.
void PrintTo(const CompletionPlane& plane, std::ostream* out) { *out << plane.name; }

class CompletionPlanes : public ::testing::TestWithParam<CompletionPlane> {};

// Where branches over one parameter end with CH, bisected between orbits that stick and solutions
// that do not.
TEST_P(CompletionPlanes, PassTheEndsOfBranches) {
  const CompletionPlane& plane = GetParam();
  const LociOptions options = options_of(plane, OrbitLocusKind::kChatterCompletes, 2);
  const OrbitLoci result = trace_loci(plane.scene, plane.first, plane.second, options);
  ASSERT_FALSE(result.loci.empty()) << result.starts << " starts, " << result.lost_starts;
  const std::vector<OrbitLocusPoint>& points = result.loci.front().points;
  ASSERT_GE(points.size(), 10u);
  for (const std::size_t i : places_of_ten()) {
    const OrbitLocusPoint& point = points[points.size() * (2 * i + 1) / 20];
    SCOPED_TRACE(std::to_string(point.value) + ", " + std::to_string(point.second));
    const double reach = 0.4 * (plane.to - plane.from);
    const OrbitBranches traced = support::sticking_branches(
        with_parameter(with_parameter(plane.scene, plane.second, point.second), plane.first,
                       point.value - 0.5 * reach),
        plane.first, {.from = point.value - reach, .to = point.value + reach, .start_values = 6});
    double nearest = 1.0;
    for (const OrbitBranch& branch : traced.branches)
      for (const SpecialPoint& special : branch.special)
        if (special.kind == SpecialKind::kChatterCompletes)
          nearest = std::min(nearest, std::abs(special.at.value / point.value - 1.0));
    EXPECT_LE(nearest, 1e-8) << traced.branches.size();
  }
}

// The first parameter where the second is at an end of its range, in 60 digits: chatter_points.csv.
TEST(CompletionLoci, PassTheCompletionsOfSixtyDigits) {
  struct Case {
    double zeta, frequency, gap, restitution;
    const char *first, *second;
    double from, to, second_to, critical;
  };
  const Case cases[] = {
      {0.0, 0.5, 0.2, 0.2, "stop.gap", "stop.restitution", 0.6, 0.8, 0.3, 0.6968762770129382},
      {0.0, 0.5, 0.2, 0.2, "forcing.frequency", "stop.gap", 0.9, 0.95, 0.3, 0.9319447927559966},
      {0.0, 0.3, 0.1, 0.8, "stop.restitution", "stop.gap", 0.75, 0.85, 0.12, 0.8102844902619205},
      {0.05, 0.4, 0.15, 0.5, "forcing.frequency", "stop.restitution", 0.5, 0.62, 0.55,
       0.5861669703142214}};
  for (const Case& one : cases) {
    SCOPED_TRACE(std::string(one.first) + " " + std::to_string(one.critical));
    Scene scene = parse_scene(
        "[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.0]\nparticipation = [1.0]\n"
        "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = 0.5\n"
        "[[stop]]\nshape = [1.0]\ngap = 0.2\nrestitution = 0.2\n",
        "oscillator.toml");
    scene = with_parameter(scene, "modal.damping_ratios.1", one.zeta);
    scene = with_parameter(scene, "forcing.frequency", one.frequency);
    scene = with_parameter(scene, "stop.gap", one.gap);
    scene = with_parameter(scene, "stop.restitution", one.restitution);
    LociOptions options;
    options.branches.from = one.from;
    options.branches.to = one.to;
    options.branches.start_values = 2;
    options.branches.finder.from_closed_form = options.branches.finder.from_random = false;
    options.second_from = *find_parameter(scene, one.second);
    options.second_to = one.second_to;
    options.kinds = {OrbitLocusKind::kChatterCompletes};
    options.slices = 1;
    const OrbitLoci result = trace_loci(scene, one.first, one.second, options);
    double nearest = 1.0;
    for (const OrbitLocus& locus : result.loci)
      for (const OrbitLocusPoint* end : {&locus.points.front(), &locus.points.back()})
        if (end->second == options.second_from)
          nearest = std::min(nearest, std::abs(end->value / one.critical - 1.0));
    EXPECT_LE(nearest, 1e-11) << result.loci.size();
  }
}

// With r = .8 hops shrink by .875 (theory.md); and lambda solves its equation.
TEST(CompletionLoci, RatioOfTheChatterThatJustCompletes) {
  EXPECT_NEAR(completing_ratio(0.8), 0.875, 5e-4);
  for (const double r : {1e-6, 0.1, 0.36, 0.5, 0.9, 0.999}) {
    const double lambda = completing_ratio(r);
    EXPECT_NEAR(lambda * lambda * (2.0 + lambda) / (1.0 + 2.0 * lambda), r, 1e-15);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Planes, CompletionPlanes,
    ::testing::Values(
        CompletionPlane{"soft stop, lower end", support::shipped_scene("09_soft_stop_two_modes"),
                        "forcing.frequency", "stop.restitution", 36.8, 37.8, 0.2, 0.4},
        CompletionPlane{"soft stop, upper end", support::shipped_scene("09_soft_stop_two_modes"),
                        "forcing.frequency", "stop.gap", 41.5, 42.1, 0.00095, 0.0012},
        CompletionPlane{
            "three modes of a beam",
            support::shipped_scene("02_wagg_momentum", {"beam.modes=3", "stop.restitution=0.4625",
                                                        "forcing.frequency=43.8"}),
            "forcing.frequency", "stop.restitution", 43.3, 44.5, 0.45, 0.5},
        CompletionPlane{"first drawn", first_drawn(0.63), "forcing.frequency", "stop.restitution",
                        0.6, 0.64, 0.25, 0.4},
        CompletionPlane{"second drawn", second_drawn(0.68), "forcing.frequency", "stop.restitution",
                        0.66, 0.7, 0.1, 0.45}));

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
              SpecialKind::kPeriodDoubling, 40.2, 41.0, 0.15, 0.35, 0.05},
        Plane{"fold of the first drawn", first_drawn(0.63), "forcing.frequency", "stop.restitution",
              OrbitLocusKind::kFold, SpecialKind::kFold, 0.6, 0.65, 0.25, 0.41},
        Plane{"doubling of the second drawn", second_drawn(0.52), "forcing.frequency",
              "stop.restitution", OrbitLocusKind::kPeriodDoubling, SpecialKind::kPeriodDoubling,
              0.51, 0.53, 0.1, 0.45},
        Plane{"fold of the second drawn", second_drawn(0.69), "forcing.frequency",
              "stop.restitution", OrbitLocusKind::kFold, SpecialKind::kFold, 0.67, 0.71, 0.3, 0.45},
        Plane{"grazing of two modes", two_modes(), "forcing.frequency", "stop.gap",
              OrbitLocusKind::kGrazing, SpecialKind::kGrazing, 0.43, 0.49, 0.08, 0.12},
        Plane{"grazing of three modes", support::reference_scene("sticking/rayl3"),
              "forcing.frequency", "stop.restitution", OrbitLocusKind::kGrazing,
              SpecialKind::kGrazing, 0.165, 0.185, 0.63, 0.67},
        Plane{"grazing of the first drawn", first_drawn(0.63), "forcing.frequency",
              "stop.restitution", OrbitLocusKind::kGrazing, SpecialKind::kGrazing, 0.6, 0.65, 0.25,
              0.41}));

}  // namespace
}  // namespace graze
