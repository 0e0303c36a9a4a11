// How directions grow: maps with published exponents.
#include "graze/base/linalg/detail/growing_directions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace graze {
namespace {

Matrix matrix(double a, double b, double c, double d) {
  Matrix m(2, 2);
  m << a, b, c, d;
  return m;
}

// x' = 4 x (1 - x) is conjugate to the tent map: its exponent is ln 2.
TEST(GrowingDirections, OfTheLogisticMap) {
  constexpr long long kSteps = 1'000'000;
  GrowingDirections directions(1);
  BlockMean mean(kSteps);
  double x = 0.1234567;
  for (long long i = 0; i < kSteps; ++i) {
    mean.add(directions.carry(4.0 * (1.0 - 2.0 * x) * directions.now()));
    x = 4.0 * x * (1.0 - x);
  }
  EXPECT_NEAR(mean.mean()[0], std::log(2.0), 5e-3);
  EXPECT_LE(std::abs(mean.mean()[0] - std::log(2.0)), 4.0 * mean.standard_error()[0]);
  EXPECT_LE(mean.standard_error()[0], 2e-3);
}

// a = 1.4, b = 0.3: 0.41922 and -1.62319 (J. C. Sprott, Chaos and Time-Series Analysis, Oxford
// 2003, appendix A.2.1). Their sum is ln b.
TEST(GrowingDirections, OfTheHenonMap) {
  constexpr long long kSteps = 2'000'000;
  GrowingDirections directions(2);
  BlockMean mean(kSteps);
  double x = 0.1, y = 0.1;
  for (long long i = 0; i < kSteps + 100; ++i) {
    const Vector growth = directions.carry(matrix(-2.8 * x, 1.0, 0.3, 0.0) * directions.now());
    const double next = 1.0 - 1.4 * x * x + y;
    y = 0.3 * x;
    x = next;
    if (i >= 100) mean.add(growth);
  }
  EXPECT_NEAR(mean.mean()[0], 0.41922, 1e-3);
  EXPECT_NEAR(mean.mean()[1], -1.62319, 1e-3);
  EXPECT_NEAR(mean.mean().sum(), std::log(0.3), 1e-11);
}

// Arnold's cat has the same derivative everywhere: the logarithms of its eigenvalues.
TEST(GrowingDirections, OfAConstantMap) {
  const Matrix cat = matrix(2.0, 1.0, 1.0, 1.0);
  GrowingDirections directions(2);
  Vector growth;
  for (int i = 0; i < 40; ++i) growth = directions.carry(cat * directions.now());
  const double exact = std::log(0.5 * (3.0 + std::sqrt(5.0)));
  EXPECT_NEAR(growth[0], exact, 1e-14);
  EXPECT_NEAR(growth[1], -exact, 1e-13);
}

// A projection loses what it projects along, whatever else happens before and after it.
TEST(GrowingDirections, AreLostForGood) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const auto any = [&](Eigen::Index n) {
    return Matrix(Matrix::NullaryExpr(n, n, [&] { return normal(random); }));
  };
  GrowingDirections directions(5);
  directions.carry(any(5) * directions.now());
  EXPECT_EQ(directions.lost(), 0);
  Matrix projection = any(5);
  projection.col(3) = projection.col(1) - 2.0 * projection.col(4);
  projection.col(0) = 1e3 * projection.col(2);
  const Vector growth = directions.carry(projection * directions.now(), 3);
  EXPECT_EQ(directions.lost(), 2);
  EXPECT_TRUE(std::isfinite(growth[2]));
  EXPECT_EQ(growth[3], -std::numeric_limits<double>::infinity());
  EXPECT_EQ(growth[4], -std::numeric_limits<double>::infinity());
  // The same projection finds nothing more to lose, but for one of their common directions.
  directions.carry(any(5) * directions.now(), 3);
  EXPECT_EQ(directions.lost(), 2);
  EXPECT_EQ(directions.now().cols(), 3);
  EXPECT_LE((directions.now().transpose() * directions.now() - Matrix::Identity(3, 3)).norm(),
            1e-15);
}

// Independent values: the standard error is what it is of any mean.
TEST(BlockMean, TellsTheErrorOfIndependentValues) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal(3.0, 2.0);
  constexpr long long kCount = 320'000;
  BlockMean mean(kCount);
  for (long long i = 0; i < kCount; ++i) mean.add(Vector::Constant(1, normal(random)));
  const double exact = 2.0 / std::sqrt(static_cast<double>(kCount));
  EXPECT_NEAR(mean.standard_error()[0] / exact, 1.0, 0.5);  // 32 blocks tell it to 13 per cent
  EXPECT_LE(std::abs(mean.mean()[0] - 3.0), 4.0 * exact);
  EXPECT_EQ(mean.count(), kCount);
}

}  // namespace
}  // namespace graze
