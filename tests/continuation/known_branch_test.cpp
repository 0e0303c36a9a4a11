// Boxes around the runs of a branch leave out nothing that lies on it.
#include "graze/continuation/branch/detail/known_branch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "graze/continuation/branch.hpp"
#include "known_problems.hpp"

namespace graze {
namespace {

using support::range;
using support::Scalar;
using support::scalar_problem;
using support::traced;

struct Known {
  Known(const ZeroProblem& equations, const ContinuationOptions& given, const Branch& branch)
      : options(given),
        corrector(equations, options),
        known(corrector, branch.points, equations.wrap, options.max_turn) {}
  bool has(double u, double parameter) {
    SolutionPoint point;
    point.u = Vector::Constant(1, u);
    point.parameter = parameter;
    return known.has(corrector, point);
  }
  ContinuationOptions options;
  Corrector corrector;
  KnownBranch known;
};

// The circle of radius 1 has every point of itself, whatever side its chords lie on, and none of a
// circle beside it.
TEST(KnownBranch, HasAllOfACircleAndNothingBesideIt) {
  const ZeroProblem problem = scalar_problem([](double u, double p) {
    return Scalar{u * u + p * p - 1.0, 2.0 * u, 2.0 * p};
  });
  const Branch branch = traced(problem, range(-2.0, 2.0), 1.0, 0.1);
  ASSERT_GT(branch.points.size(), 40u) << "more than one box";
  Known known(problem, range(-2.0, 2.0), branch);
  for (int i = 0; i < 997; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 997;
    EXPECT_TRUE(known.has(std::cos(angle), std::sin(angle))) << angle;
    EXPECT_FALSE(known.has(1.001 * std::cos(angle), 1.001 * std::sin(angle))) << angle;
    EXPECT_FALSE(known.has(2.0 * std::cos(angle), 2.0 * std::sin(angle))) << angle;
  }
}

// u = p modulo one turn: a solution some turns on is the same one.
TEST(KnownBranch, AnglesAreComparedWithoutTheirTurns) {
  ZeroProblem problem = scalar_problem([](double u, double p) {
    return Scalar{std::sin(u - p), std::cos(u - p), -std::cos(u - p)};
  });
  problem.wrap = Vector::Constant(1, 2.0 * std::numbers::pi);
  const Branch branch = traced(problem, range(0.0, 3.0), 1.0, 1.0);
  Known known(problem, range(0.0, 3.0), branch);
  for (const double turns : {-2.0, 0.0, 1.0, 5.0})
    for (const double p : {0.01, 0.7, 1.5, 2.9}) {
      EXPECT_TRUE(known.has(p + 2.0 * std::numbers::pi * turns, p)) << turns << " " << p;
      EXPECT_FALSE(known.has(p + std::numbers::pi * (2.0 * turns + 1.0), p)) << turns << " " << p;
    }
}

TEST(KnownBranch, APointAloneHasNoStretch) {
  const ZeroProblem problem = scalar_problem([](double u, double p) {
    return Scalar{u - p, 1.0, -1.0};
  });
  Branch branch = traced(problem, range(0.0, 1.0), 0.5, 0.5);
  branch.points.resize(1);
  Known known(problem, range(0.0, 1.0), branch);
  EXPECT_FALSE(known.has(0.5, 0.5));
}

}  // namespace
}  // namespace graze
