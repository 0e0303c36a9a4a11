// Eigenvalues of products of jumps of rank two and flows in blocks: against 50 digits, against the
// dense product, and where they are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "graze/base/linalg/detail/product_eigenvalues.hpp"
#include "graze/base/linalg/detail/secular_eigenvalues.hpp"
#include "support/product_reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// A structure of n modes that is hit at one place and turns and shrinks in between: the last mode's
// frequency is n^2, its damping `damping` of that.
JumpAndFlow random_factor(support::Dice& dice, int n, double damping) {
  JumpAndFlow factor;
  factor.from = factor.to = Matrix::Zero(2 * n, 2);
  factor.qq = factor.qv = factor.vq = factor.vv = factor.uncertainty = Vector::Zero(n);
  const double t = dice.uniform(0.2, 1.8);
  for (int m = 0; m < n; ++m) {
    const double omega = (m + 1) * (m + 1), shrink = std::exp(-damping * omega * t);
    factor.qq[m] = factor.vv[m] = shrink * std::cos(omega * t);
    factor.qv[m] = shrink * std::sin(omega * t);
    factor.vq[m] = -factor.qv[m];
    const double row = dice.uniform(-1.0, 1.0) * std::sqrt(2.0 / n);
    factor.to(m, 0) = factor.to(n + m, 1) = row;
    factor.from(m, 0) = factor.from(n + m, 1) = -1.8 * row;
    factor.from(n + m, 0) = dice.uniform(-2.0, 2.0) / std::sqrt(n);
  }
  return factor;
}

std::vector<JumpAndFlow> random_factors(support::Dice& dice, int count, int n, double damping) {
  std::vector<JumpAndFlow> factors;
  for (int i = 0; i < count; ++i) factors.push_back(random_factor(dice, n, damping));
  return factors;
}

Matrix jump_of(const JumpAndFlow& factor) {
  return Matrix::Identity(factor.from.rows(), factor.from.rows()) +
         factor.from * factor.to.transpose();
}

Matrix flow_of(const JumpAndFlow& factor) {
  const Eigen::Index n = factor.qq.size();
  Matrix flow = Matrix::Zero(2 * n, 2 * n);
  flow.topLeftCorner(n, n) = factor.qq.asDiagonal();
  flow.topRightCorner(n, n) = factor.qv.asDiagonal();
  flow.bottomLeftCorner(n, n) = factor.vq.asDiagonal();
  flow.bottomRightCorner(n, n) = factor.vv.asDiagonal();
  return flow;
}

// Their product with 50 digits.
support::ExtendedMatrix extended_product(const std::vector<JumpAndFlow>& factors) {
  const Eigen::Index size = factors.front().from.rows();
  support::ExtendedMatrix product = support::ExtendedMatrix::Identity(size, size);
  for (const JumpAndFlow& factor : factors) {
    const support::ExtendedMatrix jump =
        support::ExtendedMatrix::Identity(size, size) +
        factor.from.cast<Extended>() * factor.to.cast<Extended>().transpose();
    product = (flow_of(factor).cast<Extended>() * jump * product).eval();
  }
  return product;
}

TEST(SecularEigenvalues, AreThoseOfFiftyDigitsWithinTheirErrors) {
  support::Dice dice(36);
  double of_error = 0.0, given = 0.0;
  for (const double damping : {0.0, 1e-3, 0.05})
    for (const int count : {1, 2, 3})
      for (int i = 0; i < 8; ++i) {
        const std::vector<JumpAndFlow> factors = random_factors(dice, count, 6, damping);
        const auto values = secular_eigenvalues(factors, ErrorBounds::kGiven);
        ASSERT_TRUE(values) << damping << ' ' << count << ' ' << i;
        const auto compared =
            support::compare(*values, support::extended_eigenvalues(extended_product(factors)));
        of_error = std::max(of_error, compared.of_error);
        given = std::max(given, compared.given);
      }
  EXPECT_LE(of_error, 1.0);
  EXPECT_GE(of_error, 1e-3);  // and no wider than that
  EXPECT_LE(given, 1e-8);
}

TEST(SecularEigenvalues, AreThoseOfTheDenseProductWithManyModes) {
  support::Dice dice(7);
  for (const int n : {16, 40})
    for (const double damping : {0.0, 1e-3, 0.02})
      for (const int count : {1, 2}) {
        SCOPED_TRACE(std::to_string(n) + " modes, " + std::to_string(count) + " jumps, damping " +
                     std::to_string(damping));
        const std::vector<JumpAndFlow> factors = random_factors(dice, count, n, damping);
        std::vector<Matrix> dense;
        for (const JumpAndFlow& factor : factors)
          dense.push_back(flow_of(factor) * jump_of(factor));
        const auto values = secular_eigenvalues(factors, ErrorBounds::kGiven);
        ASSERT_TRUE(values);
        std::vector<Eigenvalue> expected = product_eigenvalues(dense);
        ASSERT_EQ(values->size(), expected.size());
        for (const Eigenvalue& value : *values) {
          const auto nearest = std::min_element(
              expected.begin(), expected.end(), [&](const Eigenvalue& a, const Eigenvalue& b) {
                return std::abs(a.value - value.value) < std::abs(b.value - value.value);
              });
          EXPECT_LE(std::abs(nearest->value - value.value), nearest->error + value.error);
          expected.erase(nearest);
        }
        EXPECT_NEAR(factors.front().norm() / dense.front().norm(), 1.0, 1e-12);
      }
}

TEST(SecularEigenvalues, MultiplyToTheDeterminant) {
  support::Dice dice(11);
  for (const int count : {1, 3}) {
    const std::vector<JumpAndFlow> factors = random_factors(dice, count, 24, 1e-3);
    const auto values = secular_eigenvalues(factors, ErrorBounds::kLeftOut);
    ASSERT_TRUE(values);
    double logarithm = 0.0, expected = 0.0;
    for (const Eigenvalue& value : *values) logarithm += std::log(std::abs(value.value));
    for (const JumpAndFlow& factor : factors) {
      for (int m = 0; m < 24; ++m)
        expected += std::log(std::abs(factor.qq[m] * factor.vv[m] - factor.qv[m] * factor.vq[m]));
      const Eigen::Matrix2d small =
          Eigen::Matrix2d::Identity() + factor.to.transpose() * factor.from;
      expected += std::log(std::abs(small(0, 0) * small(1, 1) - small(0, 1) * small(1, 0)));
    }
    EXPECT_NEAR(logarithm, expected, 1e-10);
  }
}

TEST(SecularEigenvalues, AreTheSameWithAndWithoutTheirErrors) {
  support::Dice dice(5);
  const std::vector<JumpAndFlow> factors = random_factors(dice, 2, 20, 1e-2);
  const auto with = secular_eigenvalues(factors, ErrorBounds::kGiven);
  const auto without = secular_eigenvalues(factors, ErrorBounds::kLeftOut);
  ASSERT_TRUE(with && without);
  for (std::size_t i = 0; i < with->size(); ++i) {
    EXPECT_EQ((*with)[i].value, (*without)[i].value);
    EXPECT_EQ((*without)[i].error, 0.0);
    // Conjugate ones stand side by side.
    if (!((*with)[i].value.imag() < 0.0)) continue;
    EXPECT_EQ((*with)[i + 1].value, std::conj((*with)[i].value));
  }
}

TEST(SecularEigenvalues, OfAModeThatTheJumpsDoNotFeelAreThoseOfItsFlow) {
  support::Dice dice(2);
  std::vector<JumpAndFlow> factors = random_factors(dice, 1, 10, 1e-2);
  JumpAndFlow& factor = factors.front();
  for (const int row : {3, 13}) factor.to.row(row).setZero();
  const auto values = secular_eigenvalues(factors, ErrorBounds::kGiven);
  ASSERT_TRUE(values);
  int found = 0;
  for (const Eigenvalue& value : *values)
    for (const double sign : {-1.0, 1.0})
      if (std::abs(value.value - Complex(factor.qq[3], sign * factor.qv[3])) <= 1e-15) ++found;
  EXPECT_EQ(found, 2);
}

TEST(SecularEigenvalues, OfTwoModesThatAreAlikeAreBothFound) {
  // Two equal poles: a jump of rank two moves both roots.
  support::Dice dice(3);
  std::vector<JumpAndFlow> factors = random_factors(dice, 1, 8, 1e-2);
  JumpAndFlow& factor = factors.front();
  for (Vector* const entry : {&factor.qq, &factor.qv, &factor.vq, &factor.vv})
    (*entry)[5] = (*entry)[4];
  const auto values = secular_eigenvalues(factors, ErrorBounds::kGiven);
  ASSERT_TRUE(values);
  EXPECT_LE(
      support::compare(*values, support::extended_eigenvalues(extended_product(factors))).of_error,
      1.0);
}

TEST(SecularEigenvalues, OfModesThatAFlowExtinguishesAreZero) {
  support::Dice dice(4);
  std::vector<JumpAndFlow> factors = random_factors(dice, 1, 8, 1e-2);
  JumpAndFlow& factor = factors.front();
  for (Vector* const entry : {&factor.qq, &factor.qv, &factor.vq, &factor.vv}) (*entry)[6] *= 1e-40;
  const auto values = secular_eigenvalues(factors, ErrorBounds::kGiven);
  ASSERT_TRUE(values);
  EXPECT_LE(
      support::compare(*values, support::extended_eigenvalues(extended_product(factors))).of_error,
      1.0);
  EXPECT_EQ((*values)[14].value, 0.0);
  EXPECT_EQ((*values)[15].value, 0.0);
  EXPECT_LE((*values)[15].error, 1e-30);
}

TEST(SecularEigenvalues, OfASingularJumpAreLeftToOthers) {
  // Without rebound the jump forgets the approach speed.
  support::Dice dice(6);
  std::vector<JumpAndFlow> factors = random_factors(dice, 1, 8, 1e-2);
  JumpAndFlow& factor = factors.front();
  factor.from.col(1) /= -factor.from.col(1).dot(factor.to.col(1));
  EXPECT_FALSE(secular_eigenvalues(factors, ErrorBounds::kGiven));
  factor.qq[0] = std::nan("");
  EXPECT_FALSE(secular_eigenvalues(factors, ErrorBounds::kGiven));
}

}  // namespace
}  // namespace graze
