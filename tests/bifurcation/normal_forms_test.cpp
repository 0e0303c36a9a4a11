// Normal forms of folds and doublings of orbits, against multipliers along the branches beside
// them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// The slope at zero of the polynomial without a constant through places and values, of degree 4.
double slope_at_zero(const std::vector<double>& at, const std::vector<double>& of) {
  constexpr Eigen::Index kDegree = 4;
  const double unit = std::abs(*std::max_element(
      at.begin(), at.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
  Matrix squares = Matrix::Zero(kDegree, kDegree);
  Vector moments = Vector::Zero(kDegree);
  for (std::size_t i = 0; i < at.size(); ++i) {
    Vector powers(kDegree);
    for (Eigen::Index k = 0; k < kDegree; ++k)
      powers[k] = std::pow(at[i] / unit, static_cast<double>(k + 1));
    squares += powers * powers.transpose();
    moments += of[i] * powers;
  }
  return PivotedLu<double>(squares).solve(moments)[0] / unit;
}

// The real multiplier nearest to 1.
double critical_multiplier(const OrbitBranchPoint& point) {
  double nearest = 1e9;
  for (const Eigenvalue& one : point.orbit.multipliers)
    if (std::abs(one.value.imag()) == 0.0 &&
        std::abs(one.value.real() - 1.0) < std::abs(nearest - 1.0))
      nearest = one.value.real();
  return nearest;
}

BranchOptions around(double value, double reach) {
  BranchOptions options;
  options.from = value - reach;
  options.to = value + reach;
  options.max_step = reach / 30.0;
  options.start_values = 2;
  options.finder.from_random = false;
  return options;
}

// On a doubled orbit at p a multiplier is 1 - 4 b (p - p0)/opening.
void expect_doubling(const SystemFamily& family, const SpecialPoint& point) {
  const double expected = -4.0 * point.normal->coefficient / point.normal->opening;
  const double reach = 0.03 / std::abs(expected);  // within which the multiplier is near 1
  BranchOptions options = around(point.at.value, reach);
  options.follow_depth = 1;
  const OrbitBranches traced = trace_orbits(family, options);
  const auto doubled =
      std::find_if(traced.branches.begin(), traced.branches.end(),
                   [](const OrbitBranch& branch) { return branch.origin.starts_with("PD"); });
  ASSERT_NE(doubled, traced.branches.end());
  std::vector<double> at, of;
  for (const OrbitBranchPoint& one : doubled->points)
    if (std::abs(one.value - point.at.value) > 1e-3 * reach) {
      at.push_back(one.value - point.at.value);
      of.push_back(critical_multiplier(one) - 1.0);
      EXPECT_EQ(at.back() > 0.0, point.normal->opening > 0.0);
    }
  ASSERT_GT(at.size(), 8u);
  EXPECT_NEAR(slope_at_zero(at, of), expected, 1e-4 * std::abs(expected));
}

// Beside a fold the multiplier is 1 + 2 a x at p0 + opening x^2.
void expect_fold(const SystemFamily& family, const SpecialPoint& point) {
  const double expected =
      2.0 * std::abs(point.normal->coefficient) / std::sqrt(std::abs(point.normal->opening));
  const double reach = std::pow(0.007 / expected, 2);
  const OrbitBranches traced = trace_orbits(family, around(point.at.value, reach));
  for (const OrbitBranch& branch : traced.branches) {
    const auto fold = std::find_if(branch.special.begin(), branch.special.end(),
                                   [](const auto& one) { return one.kind == SpecialKind::kFold; });
    if (fold == branch.special.end()) continue;
    std::vector<double> at, of;
    bool behind = false;
    for (const OrbitBranchPoint& one : branch.points) {
      const double distance = one.value - point.at.value;
      if (std::abs(distance) < 1e-4 * reach) {
        behind = true;
        continue;
      }
      EXPECT_EQ(distance > 0.0, point.normal->opening > 0.0);
      at.push_back((behind ? 1.0 : -1.0) * std::sqrt(std::abs(distance)));
      of.push_back(critical_multiplier(one) - 1.0);
    }
    ASSERT_GT(at.size(), 8u);
    EXPECT_NEAR(std::abs(slope_at_zero(at, of)), expected, 1e-4 * expected);
    return;
  }
  ADD_FAILURE() << "no fold";
}

struct FormCase {
  std::string scene, parameter;
  double from, to;
};

std::string impact_oscillator(double ratio, double gap, double restitution) {
  return fmt::format(
      "[modal]\nfrequencies = [1.0]\ndamping_ratios = [{}]\nparticipation = [1.0]\n"
      "[forcing]\namplitude = 1.0\nfrequency = 2.8\n[[stop]]\nshape = [1.0]\ngap = {}\n"
      "restitution = {}\n",
      ratio, gap, restitution);
}

TEST(NormalForms, SayWhatBranchesBesideThemDo) {
  std::vector<FormCase> cases;
  for (const double restitution : {0.6, 0.7, 0.8, 0.9})
    for (const double gap : {-0.05, 0.0, 0.1})
      cases.push_back({impact_oscillator(0.05, gap, restitution), "forcing.frequency", 2.0, 3.3});
  for (const double gap : {0.35, 0.4, 0.45, 0.5})
    cases.push_back({impact_oscillator(0.05, gap, 0.8), "forcing.frequency", 1.7, 2.2});
  const std::string sprung =
      "[lumped]\nmasses = [1]\n[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 1\ndamping = 0.05\n"
      "[forcing]\nmass = 1\nfrequency = 1.2\namplitude = ";
  for (const double amplitude : {0.015, 0.018, 0.021, 0.024})
    cases.push_back({sprung + fmt::format("{}\n", amplitude) +
                         "[[stop]]\nmass = 1\ngap = 0.1\n[stop.spring]\nstiffness = 100\n",
                     "forcing.frequency", 1.2, 1.65});
  int folds = 0, doublings = 0;
  for (const FormCase& one : cases) {
    SCOPED_TRACE(one.scene);
    const SystemFamily family(parse_scene(one.scene, "oscillator"), one.parameter);
    BranchOptions options;
    options.from = one.from;
    options.to = one.to;
    options.start_values = 4;
    options.finder.from_random = false;
    options.normal_forms = true;
    for (const OrbitBranch& branch : trace_orbits(family, options).branches)
      for (const SpecialPoint& special : branch.special) {
        if (special.kind != SpecialKind::kFold && special.kind != SpecialKind::kPeriodDoubling)
          continue;
        SCOPED_TRACE(special.id);
        ASSERT_TRUE(special.normal);
        const bool is_fold = special.kind == SpecialKind::kFold;
        (is_fold ? expect_fold : expect_doubling)(family, special);
        ++(is_fold ? folds : doublings);
      }
  }
  EXPECT_GE(folds, 6);
  EXPECT_GE(folds + doublings, 20);
}

}  // namespace
}  // namespace graze
