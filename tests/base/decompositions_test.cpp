#include "graze/base/decompositions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"

namespace graze {
namespace {

TEST(Eigenvalues, DefectiveMatricesHaveAFiniteErrorBound) {
  Matrix nilpotent(2, 2);
  nilpotent << 0, 1, 0, 0;
  for (const Eigenvalue& value : eigenvalues(nilpotent)) {
    EXPECT_LE(std::abs(value.value), value.error);
    // Elsner's bound for n = 2 and |A| = 1: sqrt(2 eps), to first order.
    EXPECT_LT(value.error, 2.0 * std::sqrt(2.0 * std::numeric_limits<double>::epsilon()));
  }
}

TEST(Eigenvalues, ComeLargestFirstWithConjugatePairsTogether) {
  Matrix matrix = Matrix::Zero(4, 4);
  matrix(0, 0) = 0.1;
  matrix.block(1, 1, 2, 2) << 0.3, -0.4, 0.4, 0.3;  // 0.3 -+ 0.4 i
  matrix(3, 3) = -2.0;
  const std::vector<Eigenvalue> values = eigenvalues(matrix);
  ASSERT_EQ(values.size(), 4u);
  EXPECT_NEAR(values[0].value.real(), -2.0, 1e-15);
  EXPECT_NEAR(std::abs(values[1].value - Complex(0.3, -0.4)), 0.0, 1e-15);
  EXPECT_NEAR(std::abs(values[2].value - Complex(0.3, 0.4)), 0.0, 1e-15);
  EXPECT_NEAR(values[3].value.real(), 0.1, 1e-15);
}

// Critical damping, x' = (y, -w^2 x - 2 w y): one eigenvector only, whatever the rounding of w^2.
TEST(ComplexModes, OfDefectiveMatricesAreNone) {
  for (double w = 0.5; w < 1000.0; w *= 1.01) {
    for (const double scale : {1.0, w, 110.18237244860363}) {
      Matrix matrix(2, 2);
      matrix << 0.0, scale, -w * w / scale, -2.0 * w;
      const ComplexModes modes = complex_modes(matrix);
      if (modes.condition > 1e6) continue;
      ADD_FAILURE() << "w = " << w << ", condition " << modes.condition;
    }
  }
}

TEST(NullVector, IsMappedToZero) {
  Matrix matrix(2, 3);
  matrix << 1, 2, 3, 4, 5, 6;
  const Vector x = null_vector(matrix);
  EXPECT_NEAR(x.norm(), 1.0, 1e-15);
  EXPECT_NEAR((matrix * x).norm(), 0.0, 1e-14);
}

TEST(MatrixExponential, OfNothingIsNothing) {
  EXPECT_EQ(matrix_exponential(Matrix(0, 0)).size(), 0);
}

TEST(NullSpaces, AreWhatASingularMatrixMapsToZeroFromEitherSide) {
  Matrix matrix(2, 3);
  matrix << 1, 2, -1, 2, 4, -2;
  const NullSpaces null = null_spaces(matrix, 2);
  ASSERT_EQ(null.right.cols(), 2);
  ASSERT_EQ(null.left.cols(), 1);
  EXPECT_NEAR((matrix * null.right).norm(), 0.0, 1e-14);
  EXPECT_NEAR((null.left.transpose() * matrix).norm(), 0.0, 1e-14);
  EXPECT_NEAR((null.right.transpose() * null.right - Matrix::Identity(2, 2)).norm(), 0.0, 1e-14);
}

TEST(ConditionNumber, IsInfiniteForASingularMatrix) {
  EXPECT_NEAR(condition_number(Eigen::Vector2d(4.0, 0.5).asDiagonal().toDenseMatrix()), 8.0, 1e-14);
  EXPECT_EQ(condition_number(Matrix::Zero(2, 2)), std::numeric_limits<double>::infinity());
}

TEST(Angle, WrapsIntoOneTurn) {
  EXPECT_EQ(wrapped(0.0), 0.0);
  EXPECT_EQ(wrapped(-1e-17), 0.0);
  EXPECT_NEAR(wrapped(-1.0), kTurn - 1.0, 1e-15);
  EXPECT_NEAR(wrapped(3.0 * kTurn + 0.5), 0.5, 1e-14);
}

}  // namespace
}  // namespace graze
