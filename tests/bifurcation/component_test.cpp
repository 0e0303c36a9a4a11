// Numbers of components: branches that cross are connected.
#include "graze/bifurcation/trace/detail/components.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "branch_checks.hpp"

namespace graze {
namespace {

// A branch with one branch point: two impacts at these phases, stops 0 and 1.
OrbitBranch crossed(double value, double first_phase, double second_phase, double speed) {
  SpecialPoint special;
  special.kind = SpecialKind::kBranchPoint;
  special.at.value = value;
  special.at.orbit.impacts = {{0, 0, first_phase, speed, {}}, {1, 0, second_phase, speed, {}}};
  OrbitBranch branch;
  branch.special = {special};
  return branch;
}

std::vector<int> numbers(const std::vector<OrbitBranch>& branches) {
  Components components(1.0, 1.0);
  for (std::size_t i = 0; i < branches.size(); ++i)
    components.add(branches[i], {0, static_cast<int>(i)});
  return components.numbers();
}

TEST(Components, AreJoinedByACommonBranchPoint) {
  OrbitBranch both = crossed(0.3, 1.0, 4.0, 2.0);
  both.special.push_back(crossed(0.7, 1.2, 4.0, 2.0).special.front());
  OrbitBranch other_way = crossed(0.7, 1.2, 4.0, 2.0);
  auto& impacts = other_way.special.front().at.orbit.impacts;
  std::swap(impacts[0], impacts[1]);
  const OrbitBranch apart = crossed(0.3, 1.1, 4.0, 2.0), elsewhere = crossed(0.5, 1.0, 4.0, 2.0);
  EXPECT_EQ(numbers({crossed(0.3, 1.0, 4.0, 2.0), both}), (std::vector{1, 1}));
  EXPECT_EQ(numbers({both, apart, elsewhere, other_way}), (std::vector{1, 2, 3, 1}));
  // Two that do not meet each other are connected by a third.
  EXPECT_EQ(numbers({crossed(0.3, 1.0, 4.0, 2.0), apart, other_way, both}),
            (std::vector{1, 2, 1, 1}));
  // A fold is no crossing.
  OrbitBranch fold = crossed(0.3, 1.0, 4.0, 2.0);
  fold.special.front().kind = SpecialKind::kFold;
  EXPECT_EQ(numbers({fold, both}), (std::vector{1, 2}));
}

TEST(Components, KeepTheirNames) {
  const OrbitBranch plain;
  Components components(1.0, 1.0);
  components.add(plain, {0, 5});
  components.add(plain, {1, 5});
  components.add(plain, {0, 5});
  EXPECT_EQ(components.numbers(), (std::vector{1, 2, 1}));
}

// An oscillator between mirrored stops: orbits that are their own mirror images lose that symmetry
// at a pitchfork, where the branch of the others begins.
TEST(Components, OfAPitchforkAreOne) {
  Scene scene =
      support::shipped_scene("04_impact_oscillator", {"forcing.frequency=1.5", "stop.gap=0.5"});
  scene.stops.push_back(scene.stops.front());
  scene.stops.back().side = Side::kBelow;
  BranchOptions options;
  options.impacts = 2;
  options.from = 1.3;
  options.to = 1.7;
  const OrbitBranches result = trace_orbits(SystemFamily(scene, "forcing.frequency"), options);
  // Where two branches have a branch point at one value and, by the impact on the first stop, at
  // one phase, they cross.
  int crossings = 0;
  const auto on_first = [](const SpecialPoint& at) {
    const auto& impacts = at.at.orbit.impacts;
    return *std::find_if(impacts.begin(), impacts.end(),
                         [](const OrbitImpact& impact) { return impact.stop == 0; });
  };
  int last = 0;
  for (std::size_t i = 0; i < result.branches.size(); ++i) {
    const OrbitBranch& a = result.branches[i];
    EXPECT_LE(a.component, last + 1);
    last = std::max(last, a.component);
    for (std::size_t j = 0; j < i; ++j)
      for (const SpecialPoint& x : a.special)
        for (const SpecialPoint& y : result.branches[j].special) {
          if (x.kind != SpecialKind::kBranchPoint || y.kind != SpecialKind::kBranchPoint ||
              std::abs(x.at.value - y.at.value) > 1e-9 ||
              std::abs(on_first(x).phase - on_first(y).phase) > 1e-7)
            continue;
          ++crossings;
          EXPECT_EQ(a.component, result.branches[j].component) << x.at.value;
        }
  }
  EXPECT_GE(crossings, 1);
}

}  // namespace
}  // namespace graze
