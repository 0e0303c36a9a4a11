// Products with multiple, defective and zero eigenvalues.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/linalg/detail/product_eigenvalues.hpp"
#include "support/product_reference.hpp"

namespace graze {
namespace {

using support::compare;
using support::Dice;
using support::extended_eigenvalues;
using support::random_matrix;
using support::random_rotation;

constexpr double kRoundoff = std::numeric_limits<double>::epsilon();

// U J U^-1 as the product of U and J U^-1 with integers, so that it is exactly defective.
std::vector<Matrix> jordan_factors(int n) {
  Matrix u = Matrix::Identity(n, n), inverse = Matrix::Identity(n, n);
  for (int i = 0; i + 1 < n; ++i) {
    Matrix add = Matrix::Identity(n, n), subtract = add;
    add(i + 1, i) = 2.0;
    subtract(i + 1, i) = -2.0;
    if (i % 2 == 0) {
      add.transposeInPlace();
      subtract.transposeInPlace();
    }
    u = (u * add).eval();
    inverse = (subtract * inverse).eval();
  }
  Matrix jordan = Matrix::Identity(n, n);
  jordan.diagonal(1).setOnes();
  return {jordan * inverse, u};
}

TEST(ProductEigenvalues, DefectiveOnesAreWithinALargeError) {
  for (const int n : {2, 3, 4}) {
    SCOPED_TRACE(n);
    const std::vector<Eigenvalue> values = product_eigenvalues(jordan_factors(n));
    ASSERT_EQ(values.size(), static_cast<std::size_t>(n));
    for (const Eigenvalue& value : values) {
      EXPECT_LE(std::abs(value.value - 1.0), value.error);
      // No bound is smaller than what the last digit of the product does to a Jordan block.
      EXPECT_GE(value.error, 0.1 * std::pow(kRoundoff, 1.0 / n));
      EXPECT_LE(value.error, 1e4 * std::pow(kRoundoff, 1.0 / n));
    }
  }
}

int exact_zeros(const std::vector<Eigenvalue>& values) {
  return static_cast<int>(std::count_if(values.begin(), values.end(),
                                        [](const Eigenvalue& v) { return v.value == 0.0; }));
}

TEST(ProductEigenvalues, SingularFactorsGiveExactZeros) {
  Dice dice(27);
  for (const int n : {2, 4, 8})
    for (int missing = 1; missing <= n; ++missing) {
      SCOPED_TRACE("n = " + std::to_string(n) + ", missing = " + std::to_string(missing));
      const Matrix basis = random_rotation(dice, n).leftCols(n - missing);
      const Matrix projection = basis * basis.transpose();
      const std::vector<Matrix> factors = {random_matrix(dice, n), projection,
                                           random_matrix(dice, n)};
      const std::vector<Eigenvalue> values = product_eigenvalues(factors);
      ASSERT_EQ(values.size(), static_cast<std::size_t>(n));
      EXPECT_EQ(exact_zeros(values), missing);
      // The projection is rounded: its zeros are those of a perturbed factor.
      for (const Eigenvalue& value : values)
        if (value.value == 0.0) {
          EXPECT_LE(value.error, 1e-10);
        }
      EXPECT_LE(compare(values, extended_eigenvalues(factors)).of_error, 1.0);
    }
}

TEST(ProductEigenvalues, SeveralSingularFactorsCombineTheirZeros) {
  // Projections on coordinates, one more left out by each; a cyclic shift in between, k = 2: of
  // four coordinates 0..3 the first factor keeps 1, 2, 3, the shift moves them to 2, 3, 0, the
  // second one keeps 2, 3.
  Matrix shift = Matrix::Zero(4, 4);
  for (int i = 0; i < 4; ++i) shift((i + 1) % 4, i) = 1.0;
  const Matrix first = Eigen::Vector4d(0, 1, 1, 1).asDiagonal();
  const Matrix second = Eigen::Vector4d(0, 0, 1, 1).asDiagonal();
  EXPECT_EQ(exact_zeros(product_eigenvalues({first, second * shift})), 4);  // nilpotent
  EXPECT_EQ(exact_zeros(product_eigenvalues({first, second})), 2);
  EXPECT_EQ(exact_zeros(product_eigenvalues({Matrix::Zero(4, 4), shift})), 4);
  for (const Eigenvalue& value : product_eigenvalues({first, second}))
    if (value.value != 0.0) {
      EXPECT_NEAR(value.value.real(), 1.0, 1e-15);
    }
}

TEST(ProductEigenvalues, ANilpotentProductKnownToRoundingIsWithinItsError) {
  // e1 -> e2 -> e3 -> 0 through a basis that is orthogonal to rounding only: the zeros are those of
  // a Jordan block up to a perturbation, some of the size eps^(1/3).
  Dice dice(28);
  for (int i = 0; i < 50; ++i) {
    const Matrix q = random_rotation(dice, 3);
    Matrix nilpotent = Matrix::Zero(3, 3);
    nilpotent(1, 0) = nilpotent(2, 1) = 1.0;
    const std::vector<Matrix> factors = {nilpotent * q.transpose(), q};
    const std::vector<Eigenvalue> values = product_eigenvalues(factors);
    EXPECT_GE(exact_zeros(values), 1);
    EXPECT_LE(compare(values, extended_eigenvalues(factors)).of_error, 1.0);
    for (const Eigenvalue& value : values) EXPECT_LE(value.error, 100.0 * std::cbrt(kRoundoff));
  }
}

TEST(ProductEigenvalues, ConvergeForFactorsOfSmallIntegers) {
  // Full of singular, defective and derogatory products.
  Dice dice(32);
  for (int i = 0; i < 3000; ++i) {
    const int n = 2 + dice.pick(6), k = 2 + dice.pick(3);
    std::vector<Matrix> factors;
    for (int m = 0; m < k; ++m) {
      Matrix factor(n, n);
      for (double& entry : factor.reshaped()) entry = dice.pick(3) - 1;
      factors.push_back(factor);
    }
    EXPECT_EQ(product_eigenvalues(factors).size(), static_cast<std::size_t>(n)) << i;
  }
}

}  // namespace
}  // namespace graze
