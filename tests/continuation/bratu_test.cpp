// The fold of the Bratu problem u'' + lambda e^u = 0, u(0) = u(1) = 0, discretised by second-order
// differences. Continuous fold: lambda = 8 (alpha/cosh alpha)^2 where alpha tanh alpha = 1.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "graze/continuation/branch.hpp"

namespace graze {
namespace {

ZeroProblem bratu(int intervals) {
  const double h2 = 1.0 / (static_cast<double>(intervals) * intervals);
  ZeroProblem problem;
  problem.evaluate = [h2](const Vector& u, Parameters parameters) -> std::optional<ZeroEvaluation> {
    const double lambda = parameters[0];
    const Eigen::Index n = u.size();
    ZeroEvaluation at{Vector(n), Matrix::Zero(n, n), Vector(n)};
    for (Eigen::Index i = 0; i < n; ++i) {
      const double left = i > 0 ? u[i - 1] : 0.0, right = i + 1 < n ? u[i + 1] : 0.0;
      const double growth = h2 * std::exp(u[i]);
      at.residual[i] = left - 2.0 * u[i] + right + lambda * growth;
      at.jacobian(i, i) = -2.0 + lambda * growth;
      if (i > 0) at.jacobian(i, i - 1) = 1.0;
      if (i + 1 < n) at.jacobian(i, i + 1) = 1.0;
      at.by_parameters(i, 0) = growth;
    }
    return at;
  };
  return problem;
}

double fold_of(int intervals) {
  const ZeroProblem problem = bratu(intervals);
  ContinuationOptions options;
  options.from = 0.0;
  options.to = 4.0;
  options.max_distance = 1.0;
  options.residual_tolerance = 1e-14;
  const auto start = solve_at(problem, options, Vector::Zero(intervals - 1), 0.5);
  EXPECT_TRUE(start);
  const Branch branch = trace_branch(problem, options, *start);
  EXPECT_EQ(branch.ends[0], BranchEnd::kParameterLimit);
  EXPECT_EQ(branch.critical_of(CriticalKind::kFold).size(), 1u) << intervals;
  return branch.critical_of(CriticalKind::kFold).front().point.parameter;
}

double continuous_fold() {
  double alpha = 1.2;
  for (int i = 0; i < 30; ++i) {
    const double t = std::tanh(alpha);
    alpha -= (alpha * t - 1.0) / (t + alpha * (1.0 - t * t));
  }
  const double ratio = alpha / std::cosh(alpha);
  return 8.0 * ratio * ratio;
}

TEST(Bratu, FoldConvergesToTheContinuousOne) {
  EXPECT_NEAR(continuous_fold(), 3.513830719125, 1e-12);
  const double coarse = fold_of(10), middle = fold_of(20), fine = fold_of(40);
  // Errors h^2 and h^4 removed by extrapolation; what is left is of order h^6.
  const double first = (4.0 * middle - coarse) / 3.0, second = (4.0 * fine - middle) / 3.0;
  EXPECT_NEAR((16.0 * second - first) / 15.0, continuous_fold(), 1e-7);
  // Order two by itself.
  EXPECT_NEAR(std::log2((coarse - continuous_fold()) / (middle - continuous_fold())), 2.0, 0.05);
}

// With two intervals the problem is one equation, -2 u + lambda e^u/4 = 0: fold at u = 1,
// lambda = 8/e. With four and symmetry it is two; with three, one: -u + lambda e^u/9, 9/e.
TEST(Bratu, FoldsOfTheSmallestGridsAreKnown) {
  EXPECT_NEAR(fold_of(2), 8.0 / std::exp(1.0), 1e-13);
  EXPECT_NEAR(fold_of(3), 9.0 / std::exp(1.0), 1e-13);
}

}  // namespace
}  // namespace graze
