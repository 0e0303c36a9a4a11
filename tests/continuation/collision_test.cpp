// Multipliers that meet, cross the unit circle and come back within one step of the branch. Two of
// them that interact are, near where they meet,
//
//   log mu = -d + i theta +- sqrt(eps^2 - kappa^2 (p - c)^2)
//
// (a collision of opposite signatures): they pass the circle at p = c +- sqrt(eps^2 - d^2)/kappa.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "known_problems.hpp"

namespace graze {
namespace {

struct Collision {
  double damping, coupling, rate, centre;  // d, eps, kappa, c
  double angle;                            // theta at p = 0
  double turn;                             // of theta, per unit of p

  double half_width() const { return std::sqrt(coupling * coupling - damping * damping) / rate; }
  // With theta = pi the two are each other's conjugates.
  std::vector<Eigenvalue> multipliers(double p) const {
    const double offset = rate * (p - centre);
    const Complex root = std::sqrt(Complex(coupling * coupling - offset * offset, 0.0));
    std::vector<Eigenvalue> list;
    const bool flips = angle == std::numbers::pi;
    for (const double sign : {1.0, -1.0}) {
      const Complex size = std::exp(-damping + sign * root);
      const double theta = angle + turn * p;
      if (flips) {
        list.push_back({-size});
        continue;
      }
      list.push_back({size * std::polar(1.0, theta)});
      list.push_back({std::conj(list.back().value)});
    }
    sort_eigenvalues(list);
    return list;
  }
};

// u = p, with these multipliers.
Branch traced(const Collision& collision) {
  ZeroProblem problem = support::straight_line();
  problem.multipliers = [&](const Vector&, Parameters parameters, ErrorBounds) {
    const double p = parameters[0];
    return collision.multipliers(p);
  };
  return support::traced(problem, {}, 0.0, 0.0);
}

void expect_both_crossings(const Collision& collision, CriticalKind kind) {
  const Branch branch = traced(collision);
  const std::vector<CriticalPoint> found = branch.critical_of(kind);
  ASSERT_EQ(found.size(), 2u) << "centre " << collision.centre << ", coupling "
                              << collision.coupling;
  EXPECT_EQ(branch.critical.size(), 2u);
  const double width = collision.half_width();
  EXPECT_NEAR(found[0].point.parameter, collision.centre - width, 1e-11);
  EXPECT_NEAR(found[1].point.parameter, collision.centre + width, 1e-11);
}

// Steps are 0.02 long: the pairs of crossings are as narrow as 1/25 of one, wherever they fall.
TEST(Collision, ToriThereAndBackWithinAStepAreFound) {
  for (const double coupling : {0.0201, 0.0205, 0.025})
    for (int i = 0; i < 40; ++i)
      expect_both_crossings({0.02, coupling, 5.0, 0.5 + 0.0005 * i, 1.2, 3.0},
                            CriticalKind::kTorus);
}

TEST(Collision, DoublingsThereAndBackWithinAStepAreFound) {
  for (const double coupling : {0.0201, 0.0205, 0.025})
    for (int i = 0; i < 40; ++i)
      expect_both_crossings({0.02, coupling, 5.0, 0.5 + 0.0005 * i, std::numbers::pi, 0.0},
                            CriticalKind::kPeriodDoubling);
}

// Multipliers that turn by two radians in a step.
TEST(Collision, FastMultipliersAreSampledAsTheyMove) {
  for (int i = 0; i < 40; ++i)
    expect_both_crossings({0.02, 0.025, 100.0, 0.5 + 0.0005 * i, 1.2, 40.0}, CriticalKind::kTorus);
}

// u ((p - c)^2 - h^2) = 0 along u = 0, its multiplier 1 + (p - c)^2 - h^2: branches cross it at
// p = c +- h, both within a step of 0.02.
TEST(Collision, BranchPointsThereAndBackWithinAStepAreFound) {
  constexpr double kHalf = 0.002;
  for (int i = 0; i < 40; ++i) {
    const double centre = 0.5 + 0.0005 * i;
    const auto distance = [=](double p) { return (p - centre) * (p - centre) - kHalf * kHalf; };
    ZeroProblem problem;
    problem.evaluate = [&](const Vector& u,
                           Parameters parameters) -> std::optional<ZeroEvaluation> {
      const double p = parameters[0];
      return ZeroEvaluation{u * distance(p), Matrix::Identity(1, 1) * distance(p),
                            2.0 * (p - centre) * u};
    };
    problem.multipliers = [&](const Vector&, Parameters parameters, ErrorBounds) {
      const double p = parameters[0];
      return std::vector<Eigenvalue>{{1.0 + distance(p)}};
    };
    const Branch branch = support::traced(problem, {}, 0.0, 0.0);
    const auto found = branch.critical_of(CriticalKind::kBranchPoint);
    ASSERT_EQ(found.size(), 2u) << centre;
    EXPECT_NEAR(found[0].point.parameter, centre - kHalf, 1e-9);
    EXPECT_NEAR(found[1].point.parameter, centre + kHalf, 1e-9);
  }
}

// Coupling below the damping: no crossing, though it comes as near as 1e-4.
TEST(Collision, ThatStaysInsideTheCircleShowsNone) {
  for (int i = 0; i < 40; ++i)
    EXPECT_TRUE(traced({0.02, 0.0199, 5.0, 0.5 + 0.0005 * i, 1.2, 3.0}).critical.empty());
}

}  // namespace
}  // namespace graze
