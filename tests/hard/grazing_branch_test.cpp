// Branches traced into their grazing, fold and flip: G2, P2 and P3 of the catalogue by
// continuation. Expected: 40 to 60 digit computations made apart from this project,
// arXiv:2510.16218 for P2, the linear response and |kappa| = a for other parameter values.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/scene/reader.hpp"
#include "support/reached.hpp"

namespace graze {
namespace {

using support::expect_reached;

struct Oscillator {
  double damping_ratio, gap, restitution, frequency;

  // Amplitude 1; the unit of force makes the natural frequency 1.
  Scene scene() const {
    return parse_scene(
        fmt::format("[modal]\nfrequencies = [1.0]\ndamping_ratios = [{}]\nparticipation = [1.0]\n"
                    "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = {}\n"
                    "[[stop]]\nshape = [1.0]\ngap = {}\nrestitution = {}\n",
                    damping_ratio, frequency, gap, restitution),
        "oscillator.toml");
  }
  // The force at which the response without impacts reaches the stop.
  double grazing_force() const {
    return gap * std::hypot(1.0 - frequency * frequency, 2.0 * damping_ratio * frequency);
  }
  // Where the closed form has its fold: |kappa| grows with the force.
  double fold_force(int period) const {
    const ClosedFormAnswer answer = closed_form(assemble(scene()), 0, period);
    return gap / std::abs(answer.form->kappa);
  }
};

OrbitBranches over_force(const Oscillator& oscillator, double from, double to, int period = 1) {
  const SystemFamily family(oscillator.scene(), "forcing.amplitude");
  BranchOptions options;
  options.period = period;
  options.from = from;
  options.to = to;
  return trace_orbits(family, options);
}

// The points at which branches end at the upper limit, slower first.
std::vector<OrbitBranchPoint> at_limit(const OrbitBranches& result, double limit) {
  std::vector<OrbitBranchPoint> points;
  for (const OrbitBranch& branch : result.branches)
    for (const OrbitBranchPoint* end : {&branch.points.front(), &branch.points.back()})
      if (end->value == limit) points.push_back(*end);
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.smallest_speed < b.smallest_speed; });
  return points;
}

const SpecialPoint* only(const OrbitBranches& result, SpecialKind kind) {
  const SpecialPoint* found = nullptr;
  int count = 0;
  for (const OrbitBranch& branch : result.branches)
    for (const SpecialPoint& special : branch.special)
      if (special.kind == kind) {
        found = &special;
        ++count;
      }
  EXPECT_EQ(count, 1);
  return found;
}

const Oscillator kCatalogue{0.05, 0.5, 0.8, 1.6};

TEST(HardCases, G2BothBranchesAreFollowedIntoTheGrazing) {
  struct Row {
    int k;
    double speed, trace;
  };
  const double grazing = 0.784091831356506353;
  for (const Row& row :
       {Row{1, 0.137511747016, 10.014975674}, Row{4, 1.36417229381e-4, 9777.742627},
        Row{8, 1.36416259507e-8, 97774968.02}}) {
    const double force = grazing * (1.0 - std::pow(10.0, -row.k));
    const OrbitBranches result = over_force(kCatalogue, 0.2, force);
    const std::vector<OrbitBranchPoint> ends = at_limit(result, force);
    ASSERT_EQ(ends.size(), 2u) << row.k;
    // Storing 1.6 and .1 as doubles moves the speed by 2e-8 at k = 8.
    const double allowed = std::max(1e-10, 40.0 * 2.2e-16 * std::pow(10.0, row.k));
    const auto& multipliers = ends[0].orbit.multipliers;
    const double trace = std::abs((multipliers[0].value + multipliers[1].value).real());
    const std::string name = "low-speed branch at F_g (1 - 1e-" + std::to_string(row.k) + "), ";
    expect_reached("G2", name + "V", std::abs(ends[0].smallest_speed / row.speed - 1.0), allowed);
    expect_reached("G2", name + "trace", std::abs(trace / row.trace - 1.0), allowed);
    if (row.k == 8) {
      expect_reached("G2", "upper branch at k = 8, V",
                     std::abs(ends[1].smallest_speed / 2.38867641229661919 - 1.0), 1e-10);
      expect_reached("G2", "upper branch at k = 8, modulus of the multipliers",
                     std::abs(std::abs(ends[1].orbit.multipliers[0].value) - 0.657379966427),
                     1e-10);
    }
  }
}

TEST(HardCases, G2FoldAndGrazingAreNamed) {
  for (const Oscillator& oscillator :
       {kCatalogue, Oscillator{0.02, 0.3, 0.6, 1.7}, Oscillator{0.1, 1.0, 0.9, 1.85},
        Oscillator{0.3, 0.5, 0.5, 1.5}}) {
    const double grazing = oscillator.grazing_force(), fold = oscillator.fold_force(1);
    const OrbitBranches result = over_force(oscillator, 0.5 * fold, 1.5 * grazing);
    const SpecialPoint* gr = only(result, SpecialKind::kGrazing);
    const SpecialPoint* lp = only(result, SpecialKind::kFold);
    ASSERT_TRUE(gr && lp);
    EXPECT_TRUE(gr->by_speed);
    expect_reached("G2", "force of the grazing", std::abs(gr->at.value / grazing - 1.0), 1e-10);
    expect_reached("G2", "force of the fold", std::abs(lp->at.value / fold - 1.0), 1e-10);
  }
  const OrbitBranches result = over_force(kCatalogue, 0.2, 1.0);
  const SpecialPoint* lp = only(result, SpecialKind::kFold);
  ASSERT_TRUE(lp);
  expect_reached("G2", "fold, F/F_g",
                 std::abs(lp->at.value / (0.784091831356506353 * 0.352831175746127748) - 1.0),
                 1e-10);
  // Beside a fold the orbit itself is known to the square root of rounding.
  EXPECT_NEAR(lp->at.smallest_speed, 1.19433821296912, 1e-7);
}

TEST(HardCases, P2FlipAndFoldOnTheirBranches) {
  const OrbitBranches flip = over_force({0.02, 1.0, 0.9, 0.81}, 0.3, 0.42, 2);
  const SpecialPoint* pd = only(flip, SpecialKind::kPeriodDoubling);
  ASSERT_TRUE(pd);
  expect_reached("P2", "force of the flip", std::abs(pd->at.value / 0.347533397412 - 1.0), 2e-12);
  // The printed force is rounded, and the speed moves with it by some 1e2 times as much.
  expect_reached("P2", "speed at the flip", std::abs(pd->at.smallest_speed - 0.0653039433369),
                 1e-10);
  const OrbitBranches fold = over_force({0.02, 1.0, 0.9, 0.799}, 0.3, 0.42, 2);
  const SpecialPoint* lp = only(fold, SpecialKind::kFold);
  ASSERT_TRUE(lp);
  expect_reached("P2", "force of the fold", std::abs(lp->at.value / 0.3628362019809 - 1.0), 1e-12);
}

// The closer both are, the less of the branch lies between them.
TEST(HardCases, P3FoldAndGrazingAreBothNamedInOrder) {
  for (const double damping : {0.05, 0.02, 0.2}) {
    const Oscillator oscillator{damping, 1.0, 0.8, 1.0};
    const double grazing = oscillator.grazing_force(), fold = oscillator.fold_force(1);
    const OrbitBranches result = over_force(oscillator, 0.5 * fold, 2.0 * grazing);
    const SpecialPoint* gr = only(result, SpecialKind::kGrazing);
    const SpecialPoint* lp = only(result, SpecialKind::kFold);
    ASSERT_TRUE(gr && lp);
    expect_reached("P3", "fold", std::abs(lp->at.value / fold - 1.0), 1e-10);
    expect_reached("P3", "grazing", std::abs(gr->at.value / grazing - 1.0), 1e-10);
    if (damping != 0.05) continue;
    EXPECT_NEAR(lp->at.value, 0.0999707536283, 1e-12);
    EXPECT_NEAR(gr->at.value, 0.1, 1e-11);
    // In order along the branch: the fold between the grazing and the limit.
    for (const OrbitBranch& branch : result.branches)
      for (std::size_t i = 0; i + 1 < branch.special.size(); ++i) {
        const bool ordered = branch.ends[0] == OrbitBranchEnd::kGrazing
                                 ? branch.special[i].kind == SpecialKind::kGrazing
                                 : branch.special[i].kind == SpecialKind::kFold;
        EXPECT_TRUE(ordered);
      }
  }
}

}  // namespace
}  // namespace graze
