// Least squares against what is known in closed form.
#include "graze/fit/detail/least_squares.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graze/fit/detail/jacobian_factors.hpp"
#include "graze/fit/detail/parameter_uncertainty.hpp"
#include "noisy.hpp"

namespace graze {
namespace {

LeastSquaresProblem exponential_problem() {
  // y = a e^{-b t} at 12 places with a = 2, b = 0.7.
  LeastSquaresProblem problem;
  problem.residuals = [](const Vector& p) -> std::optional<Vector> {
    const Vector t = Vector::LinSpaced(12, 0.0, 3.0);
    return Vector(p[0] * (-p[1] * t.array()).exp() - 2.0 * (-0.7 * t.array()).exp());
  };
  problem.start = Eigen::Vector2d(1.0, 0.1);
  problem.low = Eigen::Vector2d(0.1, 0.0);
  problem.high = Eigen::Vector2d(10.0, 5.0);
  problem.logarithmic = {true, false};
  problem.size = 4.0;
  return problem;
}

TEST(LeastSquares, FindsTheMinimumToRounding) {
  const LeastSquaresResult result = solve_least_squares(exponential_problem(), {false, 1000});
  EXPECT_EQ(result.end, LeastSquaresEnd::kConverged);
  EXPECT_NEAR(result.parameters[0], 2.0, 1e-11);
  EXPECT_NEAR(result.parameters[1], 0.7, 1e-11);
  EXPECT_EQ(result.at_limit, (std::vector<bool>{false, false}));
}

TEST(LeastSquares, TakesTheDerivativeToManyDigits) {
  const LeastSquaresProblem problem = exponential_problem();
  const Eigen::Vector2d at(1.5, 0.4);
  for (const double change : {0.05, 1e-4}) {
    const auto jacobian = difference_jacobian(problem.residuals, at, problem.low, problem.high,
                                              Eigen::Vector2d(0.1, 0.1), change);
    ASSERT_TRUE(jacobian.has_value());
    const Vector t = Vector::LinSpaced(12, 0.0, 3.0);
    const Vector by_a = (-0.4 * t.array()).exp(), by_b = -1.5 * t.array() * by_a.array();
    EXPECT_LT((jacobian->matrix.col(0) - by_a).norm(), 1e-8 * by_a.norm());
    EXPECT_LT((jacobian->matrix.col(1) - by_b).norm(), 1e-5 * by_b.norm());
    EXPECT_LT(jacobian->error, 1e-2);
    // The step changes the residuals by what was asked, to a factor of two.
    const double made = jacobian->steps[1] * by_b.norm();
    EXPECT_GT(made, 0.45 * change);
    EXPECT_LT(made, 2.2 * change);
  }
}

// On a limit differences are taken to the inside alone.
TEST(LeastSquares, TakesTheDerivativeOnALimit) {
  LeastSquaresProblem problem = exponential_problem();
  const Residuals inside = [&](const Vector& p) -> std::optional<Vector> {
    if (p[1] > 0.4) return {};
    return problem.residuals(p);
  };
  const auto jacobian =
      difference_jacobian(inside, Eigen::Vector2d(1.5, 0.4), problem.low,
                          Eigen::Vector2d(10.0, 0.4), Eigen::Vector2d(0.1, 0.1), 1e-4);
  ASSERT_TRUE(jacobian.has_value());
  const Vector t = Vector::LinSpaced(12, 0.0, 3.0);
  const Vector by_b = -1.5 * t.array() * (-0.4 * t.array()).exp();
  EXPECT_LT((jacobian->matrix.col(1) - by_b).norm(), 1e-5 * by_b.norm());
}

// With b held at 1 the best a is (e.y)/(e.e), e = e^{-t}.
TEST(LeastSquares, HoldsAParameterAtItsLimit) {
  LeastSquaresProblem problem = exponential_problem();
  problem.low[1] = 1.0;
  const LeastSquaresResult result = solve_least_squares(problem, {false, 1000});
  EXPECT_EQ(result.end, LeastSquaresEnd::kConverged);
  EXPECT_EQ(result.at_limit, (std::vector<bool>{false, true}));
  EXPECT_EQ(result.parameters[1], 1.0);
  const Vector t = Vector::LinSpaced(12, 0.0, 3.0);
  const Vector e = (-t.array()).exp(), y = 2.0 * (-0.7 * t.array()).exp();
  EXPECT_NEAR(result.parameters[0], e.dot(y) / e.dot(e), 1e-6);
}

// |J (p - (-1, -1))|^2 with J^T J = [[9, -6], [-6, 5]] asks for less of both parameters at (0, 0),
// where both limits are. With x held there the best y is -1 + 6/5.
TEST(LeastSquares, LetsGoOfALimitOnceAnotherHolds) {
  LeastSquaresProblem problem;
  problem.residuals = [](const Vector& p) -> std::optional<Vector> {
    return Vector(Eigen::Vector3d(3.0 * (p[0] + 1.0) - 2.0 * (p[1] + 1.0), p[1] + 1.0, 1.0));
  };
  problem.start = Eigen::Vector2d(1.0, 1.0);
  problem.low = Eigen::Vector2d(0.0, 0.0);
  problem.high = Eigen::Vector2d(5.0, 5.0);
  problem.logarithmic = {false, false};
  problem.linear = true;
  const LeastSquaresResult result = solve_least_squares(problem, {false, 1000});
  EXPECT_EQ(result.end, LeastSquaresEnd::kConverged);
  EXPECT_EQ(result.at_limit, (std::vector<bool>{true, false}));
  EXPECT_EQ(result.parameters[0], 0.0);
  EXPECT_NEAR(result.parameters[1], 0.2, 1e-9);
}

// A sum of squares with a second valley: sin(p t) against sin(3 t).
TEST(LeastSquares, SearchesTheBoxIfAsked) {
  LeastSquaresProblem problem;
  problem.residuals = [](const Vector& p) -> std::optional<Vector> {
    const Vector t = Vector::LinSpaced(40, 0.0, 6.0);
    return Vector((p[0] * t.array()).sin() - (3.0 * t.array()).sin());
  };
  problem.start = Vector::Constant(1, 9.0);
  problem.low = Vector::Constant(1, 0.5);
  problem.high = Vector::Constant(1, 10.0);
  problem.logarithmic = {false};
  problem.size = 4.0;
  const LeastSquaresResult local = solve_least_squares(problem, {false, 1000});
  EXPECT_GT(std::abs(local.parameters[0] - 3.0), 0.1);
  const LeastSquaresResult global = solve_least_squares(problem, {true, 1000});
  EXPECT_EQ(global.end, LeastSquaresEnd::kConverged);
  EXPECT_NEAR(global.parameters[0], 3.0, 1e-11);
}

// (1 + |x - y|)^2 + (x + y - 1)^2/10 is 1 at x = y = 1/2, where it has a kink, and more elsewhere.
TEST(LeastSquares, FindsAMinimumAtAKink) {
  LeastSquaresProblem problem;
  problem.residuals = [](const Vector& p) -> std::optional<Vector> {
    Vector r = Vector::Constant(10, 2.0);  // the rest is noise
    r[0] = 1.0 + std::abs(p[0] - p[1]);
    r[1] = std::sqrt(0.1) * (p[0] + p[1] - 1.0);
    return r;
  };
  problem.start = Eigen::Vector2d(4.0, -3.0);
  problem.low = Eigen::Vector2d(-5.0, -5.0);
  problem.high = Eigen::Vector2d(5.0, 5.0);
  problem.logarithmic = {false, false};
  const LeastSquaresResult result = solve_least_squares(problem, {false, 5000});
  EXPECT_EQ(result.end, LeastSquaresEnd::kConverged) << result.method;
  // The noise is sqrt(33/8), and so are the uncertainties at least.
  EXPECT_NEAR(result.parameters[0], result.parameters[1], 5e-3);
  EXPECT_NEAR(result.parameters.sum(), 1.0, 2e-2);
}

TEST(LeastSquares, EndsAtItsBudgetAndWhenStopped) {
  LeastSquaresResult result = solve_least_squares(exponential_problem(), {false, 15});
  EXPECT_EQ(result.end, LeastSquaresEnd::kBudget);
  EXPECT_LE(result.evaluations, 15);
  EXPECT_GT(result.residuals.size(), 0);
  const std::atomic<bool> interrupted{true};
  LeastSquaresOptions options{false, 1000};
  options.stop.interrupted = &interrupted;
  result = solve_least_squares(exponential_problem(), options);
  EXPECT_EQ(result.end, LeastSquaresEnd::kStopped);
  EXPECT_EQ(result.evaluations, 0);
}

TEST(LeastSquares, SaysWhereTheModelHasNoValue) {
  LeastSquaresProblem problem = exponential_problem();
  problem.residuals = [](const Vector&) -> std::optional<Vector> { return {}; };
  EXPECT_EQ(solve_least_squares(problem, {false, 100}).end, LeastSquaresEnd::kNoValue);
}

// Columns (1, 1, 1) and (2, 2, 2), and one of nothing.
TEST(JacobianFactors, TellWhatIsNotDetermined) {
  Matrix jacobian(3, 4);
  jacobian << 1, 2, 0, 0, 1, 2, 1, 0, 1, 2, 0, 0;
  const JacobianFactors factors(jacobian, 0.0);
  EXPECT_EQ(factors.rank(), 2);
  const auto directions = factors.untold();
  ASSERT_EQ(directions.size(), 2u);
  std::vector<bool> named(4, false);
  for (const auto& direction : directions)
    for (const Eigen::Index j : direction) named[static_cast<std::size_t>(j)] = true;
  EXPECT_EQ(named, (std::vector<bool>{true, true, false, true}));
}

// Of [[1, 0], [1, 1], [1, 2]]: J^T J = [[3, 3], [3, 5]], its inverse [[5, -3], [-3, 3]]/6.
TEST(JacobianFactors, InvertTheNormalMatrix) {
  Matrix jacobian(3, 2);
  jacobian << 1, 0, 1, 1, 1, 2;
  Matrix inverse(2, 2);
  inverse << 5.0 / 6.0, -0.5, -0.5, 0.5;
  const JacobianFactors factors(jacobian, 0.0);
  EXPECT_LT((factors.inverse_normal() - inverse).norm(), 1e-14);
  // The line through (0, 1), (1, 3), (2, 2): 1.5 + 0.5 t.
  EXPECT_LT((factors.step(-Eigen::Vector3d(1, 3, 2)) - Eigen::Vector2d(1.5, 0.5)).norm(), 1e-14);
}

// W. S. Gosset's table, as in M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions,
// table 26.10, A = 0.95, and the normal deviate of table 26.2.
TEST(ConfidenceQuantile, IsThatOfThePublishedTable) {
  EXPECT_NEAR(confidence_quantile(1), 12.706, 5e-4);
  EXPECT_NEAR(confidence_quantile(2), 4.303, 5e-4);
  EXPECT_NEAR(confidence_quantile(5), 2.571, 5e-4);
  EXPECT_NEAR(confidence_quantile(10), 2.228, 5e-4);
  EXPECT_NEAR(confidence_quantile(30), 2.042, 5e-4);
  EXPECT_NEAR(confidence_quantile(120), 1.980, 5e-4);
  EXPECT_NEAR(confidence_quantile(0), 1.959964, 5e-7);
}

}  // namespace
}  // namespace graze
