#include "graze/base/linalg/decompositions.hpp"

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

// (.4, 1; 0, .4) behind a turn: rounding parts the double eigenvalue, within its error.
TEST(Eigenvalues, ADoubleRealOneIsKnownAsReal) {
  const double sine = 0.6, cosine = 0.8;
  Matrix block(2, 2), turn(2, 2);
  turn << cosine, -sine, sine, cosine;
  for (const double split : {0.0, -1e-17, -4e-16}) {  // of the last: +-2e-8 i
    block << 0.4, 1.0, split, 0.4;
    for (const Eigenvalue& value : eigenvalues(turn * block * turn.transpose())) {
      EXPECT_EQ(value.known().imag(), 0.0) << split;
      EXPECT_NEAR(value.known().real(), 0.4, 1e-7);
    }
  }
  block << 0.4, 1.0, -1e-12, 0.4;
  for (const Eigenvalue& value : eigenvalues(turn * block * turn.transpose()))
    EXPECT_NEAR(std::abs(value.known().imag()), 1e-6, 1e-8);
}

// [2, a, 0; 0, 1, 0; 0, 0, -3]: right and left vectors of 2 and 1 have the condition number
// sqrt(1 + a^2), those of -3 have 1; also behind a rotation.
TEST(Eigenvalues, ErrorsAreThoseOfTheirConditionNumbers) {
  const double a = 40.0, sine = 0.6, cosine = 0.8;
  Matrix matrix(3, 3), turn(3, 3);
  matrix << 2, a, 0, 0, 1, 0, 0, 0, -3;
  turn << cosine, -sine, 0, sine, cosine, 0, 0, 0, 1;
  for (const Matrix& m : {matrix, Matrix(turn * matrix * turn.transpose())}) {
    const std::vector<Eigenvalue> values = eigenvalues(m);
    ASSERT_EQ(values.size(), 3u);
    const double unit = 3.0 * std::numeric_limits<double>::epsilon() * matrix.norm();
    EXPECT_NEAR(values[0].error / unit, 1.0, 1e-12);
    EXPECT_NEAR(values[1].error / unit, std::sqrt(1.0 + a * a), 1e-9);
    EXPECT_NEAR(values[2].error / unit, std::sqrt(1.0 + a * a), 1e-9);
  }
  // [0, 1; -w^2, 0] has the values +-i w, right vectors (1, +-i w) and left ones (+-i w, 1): the
  // condition number (1 + w^2)/(2 w).
  const double w = 25.0;
  Matrix oscillator(2, 2);
  oscillator << 0, 1, -w * w, 0;
  const double unit = 2.0 * std::numeric_limits<double>::epsilon() * oscillator.norm();
  for (const Eigenvalue& value : eigenvalues(oscillator))
    EXPECT_NEAR(value.error / unit, (1.0 + w * w) / (2.0 * w), 1e-12);
}

TEST(Eigenvalues, AreTheSameWithoutTheirErrors) {
  for (const int n : {1, 2, 5, 8, 16, 17, 24}) {
    const Matrix matrix = Matrix::NullaryExpr(n, n, [](Eigen::Index i, Eigen::Index j) {
      return std::sin(1.0 + 3.0 * static_cast<double>(i * i) + 7.0 * static_cast<double>(j));
    });
    const std::vector<Eigenvalue> with = eigenvalues(matrix);
    const std::vector<Eigenvalue> without = eigenvalues(matrix, ErrorBounds::kLeftOut);
    ASSERT_EQ(with.size(), static_cast<std::size_t>(n));
    ASSERT_EQ(without.size(), with.size());
    for (std::size_t j = 0; j < with.size(); ++j) {
      EXPECT_EQ(with[j].value, without[j].value);
      EXPECT_GT(with[j].error, 0.0);
      EXPECT_EQ(without[j].error, 0.0);
    }
  }
}

// Row i of a circulant matrix is its first row c turned by i: the eigenvalues are the sums of
// c_k e^{2 pi i j k/n}. Of a mere permutation all have one modulus, and shifts by the eigenvalues
// of the last rows lead nowhere.
TEST(Eigenvalues, OfCirculantMatricesAreFourierSums) {
  for (const int n : {1, 2, 3, 4, 7, 8, 15, 16, 17, 40})
    for (const bool permutation : {true, false}) {
      SCOPED_TRACE(testing::Message() << n << (permutation ? " permutation" : ""));
      Vector c = Vector::Zero(n);
      for (int k = 0; k < n; ++k)
        c[k] = permutation ? (k == 1 % n ? 1.0 : 0.0) : std::cos(1.0 + k * k);
      const Matrix matrix = Matrix::NullaryExpr(
          n, n, [&](Eigen::Index i, Eigen::Index j) { return c[(j - i + n) % n]; });
      std::vector<Complex> expected;
      for (int j = 0; j < n; ++j) {
        Complex sum = 0.0;
        for (int k = 0; k < n; ++k) sum += c[k] * std::polar(1.0, kTurn * j * k / n);
        expected.push_back(sum);
      }
      const std::vector<Eigenvalue> values = eigenvalues(matrix);
      ASSERT_EQ(values.size(), expected.size());
      for (const Complex& wanted : expected) {
        double nearest = 1.0;
        for (const Eigenvalue& value : values)
          nearest = std::min(nearest, std::abs(value.value - wanted));
        EXPECT_LE(nearest, 1e-13 * n);
      }
    }
}

TEST(Eigenvalues, AreNoneOfWhatIsNoMatrixOfNumbers) {
  Matrix matrix = Matrix::Identity(3, 3);
  matrix(1, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(eigenvalues(matrix).empty());
  EXPECT_TRUE(eigenvalues(Matrix(0, 0)).empty());
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
