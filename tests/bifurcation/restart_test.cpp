// Special points as starts: what a branch or a locus is traced from again.
#include "graze/bifurcation/loci/restart.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "branch_checks.hpp"
#include "graze/scene/parameter.hpp"

namespace graze {
namespace {

constexpr const char* kFrequencyName = "forcing.frequency";

BranchOptions between(double from, double to) {
  BranchOptions options;
  options.from = from;
  options.to = to;
  options.start_values = 8;
  options.sticking = options.finder.from_simulation = options.finder.from_random = false;
  return options;
}

OrbitBranches again(const Scene& scene, const BranchOptions& options, const SpecialOrbit& from,
                    bool switched = false) {
  BranchOptions only = options;
  only.start = BranchStart{from, true, switched};
  return trace_orbits(
      SystemFamily(with_parameter(scene, kFrequencyName, from.values[0]), kFrequencyName), only);
}

// Fold, doublings, tori and grazings of the two-mode beam: each leads to a branch that has it.
TEST(Restart, EverySpecialPointIsFoundAgainFromItself) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode", {"beam.modes=2", "stop.gap=2e-3"});
  const BranchOptions options = between(42.0, 50.0);
  const OrbitBranches first = trace_orbits(SystemFamily(scene, kFrequencyName), options);
  const std::vector<SpecialOrbit> points = special_orbits(first, assemble(scene));
  ASSERT_GE(points.size(), 8u);
  for (const SpecialOrbit& point : points) {
    SCOPED_TRACE(point.id);
    const OrbitBranches found = again(scene, options, point);
    EXPECT_EQ(found.cut_short, 0);
    ASSERT_EQ(found.branches.size(), 1u);
    double nearest = 1.0;
    for (const SpecialPoint* special : support::special_points(found, *point.kind))
      nearest = std::min(nearest, std::abs(special->at.value - point.values[0]));
    EXPECT_LE(nearest, 1e-10);
  }
}

// Orbits of two stops alike that are their own mirror images lose that at branch points.
TEST(Restart, ABranchPointLeadsBothWays) {
  const Scene scene = support::shipped_scene("07_two_stops", {"forcing.frequency=26.7"});
  BranchOptions options = between(26.45, 27.5);
  options.impacts = 2;
  options.finder.from_random = true;
  options.start_values = 0;
  const OrbitBranches first = trace_orbits(SystemFamily(scene, kFrequencyName), options);
  const auto crossings = support::special_points(first, SpecialKind::kBranchPoint);
  ASSERT_EQ(crossings.size(), 2u);
  const auto asymmetry = [](const OrbitBranchPoint& point) {
    return std::abs(point.orbit.impacts[0].speed / point.orbit.impacts[1].speed - 1.0);
  };
  for (const SpecialOrbit& point : special_orbits(first, assemble(scene))) {
    if (point.kind != SpecialKind::kBranchPoint) continue;
    SCOPED_TRACE(point.id);
    const OrbitBranches same = again(scene, options, point);
    ASSERT_EQ(same.branches.size(), 1u);
    const auto found = support::special_points(same, SpecialKind::kBranchPoint);
    ASSERT_EQ(found.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(found[i]->at.value, crossings[i]->at.value, 1e-11);
    for (const OrbitBranchPoint& orbit : same.branches[0].points)
      EXPECT_LE(asymmetry(orbit), 1e-6) << orbit.value;
    const OrbitBranches other = again(scene, options, point, true);
    ASSERT_EQ(other.branches.size(), 1u);
    ASSERT_EQ(support::special_points(other, SpecialKind::kBranchPoint).size(), 1u);
    EXPECT_NEAR(support::special_points(other, SpecialKind::kBranchPoint)[0]->at.value,
                point.values[0], 1e-9);
    EXPECT_GE(asymmetry(other.branches[0].points.front()), 1e-3);
    EXPECT_GE(asymmetry(other.branches[0].points.back()), 1e-3);
  }
}

// A point of codimension two lies on the locus it was found on.
TEST(Restart, ALocusIsTracedAgainFromItsSpecialPoint) {
  const Scene scene =
      support::shipped_scene("05_wagg_one_mode", {"forcing.frequency=54", "stop.gap=1.25e-3"});
  LociOptions options;
  options.branches = between(53.5, 54.5);
  options.second_from = 1.2e-3;
  options.second_to = 1.3e-3;
  options.slices = 2;
  options.kinds = {OrbitLocusKind::kPeriodDoubling};
  const OrbitLoci first = trace_loci(scene, kFrequencyName, "stop.gap", options);
  const std::vector<SpecialOrbit> points = special_orbits(first);
  ASSERT_EQ(points.size(), 1u);
  const double frequency = points[0].values[0], gap = points[0].values[1];
  const System there =
      assemble(with_parameter(with_parameter(scene, kFrequencyName, frequency), "stop.gap", gap));
  options.start = locus_start(there, points[0], frequency, gap);
  ASSERT_TRUE(options.start);
  const OrbitLoci found = trace_loci(scene, kFrequencyName, "stop.gap", options);
  ASSERT_EQ(found.loci.size(), 1u);
  EXPECT_EQ(found.slices, 0);
  ASSERT_EQ(found.loci[0].special.size(), 1u);
  EXPECT_EQ(found.loci[0].special[0].label, "PDGR");
  EXPECT_NEAR(found.loci[0].special[0].at.value, frequency, 1e-9);
}

// Left of 20 rad/s the (1, 1) solutions of the one-mode beam impact at negative speed.
TEST(Restart, AVirtualPointIsRefusedInWords) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode", {});
  BranchOptions options = between(15.0, 25.0);
  options.keep_virtual = true;
  const OrbitBranches first = trace_orbits(SystemFamily(scene, kFrequencyName), options);
  int virtual_points = 0;
  for (const SpecialOrbit& point : special_orbits(first, assemble(scene))) {
    if (point.kind != SpecialKind::kFold) continue;
    ++virtual_points;
    EXPECT_EQ(again(scene, options, point).branches.size(), 1u);
    BranchOptions orbits = options;
    orbits.keep_virtual = false;
    const OrbitBranches none = again(scene, orbits, point);
    EXPECT_TRUE(none.branches.empty());
    ASSERT_EQ(none.notes.size(), 1u);
    EXPECT_NE(none.notes[0].find("--virtual"), std::string::npos);
  }
  EXPECT_GE(virtual_points, 1);
}

TEST(Restart, WhatHasNoLocusStartsNone) {
  SpecialOrbit crossing;
  crossing.label = "BP";
  crossing.kind = SpecialKind::kBranchPoint;
  const System system = assemble(support::shipped_scene("05_wagg_one_mode", {}));
  EXPECT_FALSE(locus_start(system, crossing, 1.0, 1.0));
  crossing.label = "GR";
  crossing.kind = SpecialKind::kGrazing;
  crossing.by_push = true;
  EXPECT_FALSE(locus_start(system, crossing, 1.0, 1.0));
}

}  // namespace
}  // namespace graze
