// Eigenvalues of products against 50-digit arithmetic and closed forms: no true error may exceed
// the error that is given.
#include "graze/base/linalg/detail/product_eigenvalues.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <sstream>

#include "graze/base/angle.hpp"
#include "support/product_reference.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

using support::compare;
using support::Comparison;
using support::Dice;
using support::extended_eigenvalues;
using support::ExtendedComplex;
using support::random_matrix;
using support::random_rotation;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

TEST(ProductEigenvalues, RandomProductsAreWithinTheirErrors) {
  Dice dice(21);
  for (const int n : {2, 3, 4, 6, 8, 16})
    for (const int k : {2, 3, 5, 8, 40}) {
      SCOPED_TRACE("n = " + std::to_string(n) + ", k = " + std::to_string(k));
      std::vector<Matrix> factors;
      for (int i = 0; i < k; ++i) factors.push_back(random_matrix(dice, n));
      const Comparison worst = compare(factors);
      EXPECT_LE(worst.of_error, 1.0);
      // Forty random factors spread over 1e20, and every eigenvalue keeps its digits.
      EXPECT_LE(worst.of_value, 1e-10);
      EXPECT_LE(worst.given, 1e-7);
    }
}

// The factors of a row of product_eigenvalues.csv (see product_eigenvalues.py).
std::vector<Matrix> tabled_factors(const support::TableRow& row) {
  std::uint64_t x = std::stoull(row.at("seed"));
  std::vector<int> exponents;
  std::stringstream cell(row.at("exponents"));
  for (int exponent = 0; cell >> exponent;) exponents.push_back(exponent);
  const int n = std::stoi(row.at("n")), k = std::stoi(row.at("k"));
  std::vector<Matrix> factors;
  for (int i = 0; i < k; ++i) {
    Matrix factor(n, n);
    for (double& entry : factor.reshaped()) {
      x = 6364136223846793005u * x + 1442695040888963407u;
      entry = std::ldexp(static_cast<double>(x >> 11) * 0x1p-52 - 1.0,
                         exponents[static_cast<std::size_t>(i) % exponents.size()]);
    }
    factors.push_back(factor);
  }
  return factors;
}

TEST(ProductEigenvalues, AreThoseOfTheTable) {
  std::map<std::string, std::vector<Eigenvalue>> cases;
  for (const support::TableRow& row : support::read_table("product_eigenvalues.csv")) {
    SCOPED_TRACE(row.at("case"));
    std::vector<Eigenvalue>& values = cases[row.at("case")];
    if (values.empty()) values = product_eigenvalues(tabled_factors(row));
    const Complex expected(support::number(row, "re"), support::number(row, "im"));
    const auto nearest =
        std::min_element(values.begin(), values.end(), [&](const auto& a, const auto& b) {
          return std::abs(a.value - expected) < std::abs(b.value - expected);
        });
    ASSERT_NE(nearest, values.end());
    // The table's own digits end at a rounding of the double.
    EXPECT_LE(std::abs(nearest->value - expected), nearest->error + kEpsilon * std::abs(expected));
    EXPECT_LE(nearest->error, 1e-9 * std::abs(expected));
    EXPECT_EQ(nearest->value.imag() == 0.0, expected.imag() == 0.0);
  }
}

TEST(ProductEigenvalues, ManySmallRandomProductsAreWithinTheirErrors) {
  Dice dice(22);
  for (int i = 0; i < 1000; ++i) {
    const int n = 2 + dice.pick(3), k = 2 + dice.pick(4);
    std::vector<Matrix> factors;
    for (int m = 0; m < k; ++m) factors.push_back(random_matrix(dice, n));
    EXPECT_LE(compare(factors).of_error, 1.0) << i;
  }
}

TEST(ProductEigenvalues, FactorsOfVeryDifferentSizesAreWithinTheirErrors) {
  Dice dice(23);
  for (const int n : {2, 4, 8})
    for (const int k : {2, 5, 8}) {
      SCOPED_TRACE("n = " + std::to_string(n) + ", k = " + std::to_string(k));
      std::vector<Matrix> factors;
      for (int i = 0; i < k; ++i)
        factors.push_back(random_matrix(dice, n) * (i % 2 == 0 ? 1e8 : 1e-8));
      const Comparison worst = compare(factors);
      EXPECT_LE(worst.of_error, 1.0);
      EXPECT_LE(worst.of_value, 1e-11);
    }
}

TEST(ProductEigenvalues, GradedFactorsAreWithinTheirErrors) {
  Dice dice(24);
  for (int i = 0; i < 100; ++i) {
    const int n = 2 + dice.pick(5), k = 2 + dice.pick(4);
    std::vector<Matrix> factors;
    for (int m = 0; m < k; ++m) {
      Vector grade(n);
      for (double& g : grade) g = std::pow(10.0, dice.uniform(-4.0, 4.0));
      const Matrix matrix = random_matrix(dice, n);
      factors.push_back(dice.pick(2) == 0 ? Matrix(matrix * grade.asDiagonal())
                                          : Matrix(grade.asDiagonal() * matrix));
    }
    EXPECT_LE(compare(factors).of_error, 1.0) << i;
  }
}

// Structures with damped quick modes: factors X_{i+1} D X_i^T (1 + u v^T) with rotations X_i, D
// falling to 1e-24, whose eigenvalues crowd about 0 and have no vectors to speak of.
std::vector<Matrix> quickly_damped(Dice& dice, int n, int k) {
  std::vector<Matrix> bases, factors;
  for (int i = 0; i < k; ++i) bases.push_back(random_rotation(dice, n));
  Vector sizes(n);
  for (int j = 0; j < n; ++j) sizes[j] = 0.8 * std::exp(-60.0 * j * j / (n * n));
  for (std::size_t i = 0; i < bases.size(); ++i) {
    Vector u(n), v(n);
    for (double& entry : u) entry = dice.uniform(-1.0, 1.0);
    for (double& entry : v) entry = dice.uniform(-1.0, 1.0);
    const Matrix jump = Matrix::Identity(n, n) - 0.5 * u * v.transpose();
    factors.push_back(bases[(i + 1) % bases.size()] * sizes.asDiagonal() * jump *
                      bases[i].transpose());
  }
  return factors;
}

TEST(ProductEigenvalues, ThoseThatCrowdAboutZeroAreBoundedTogether) {
  Dice dice(27);
  for (const int n : {8, 16, 24})
    for (const int k : {1, 2, 3}) {
      SCOPED_TRACE("n = " + std::to_string(n) + ", k = " + std::to_string(k));
      const std::vector<Matrix> factors = quickly_damped(dice, n, k);
      std::vector<Eigenvalue> values = product_eigenvalues(factors);
      // Several are 0: the one that is known best takes the nearest.
      std::sort(values.begin(), values.end(),
                [](const Eigenvalue& a, const Eigenvalue& b) { return a.error < b.error; });
      EXPECT_LE(compare(values, extended_eigenvalues(factors)).of_error, 1.0);
      for (const Eigenvalue& value : values) EXPECT_LE(value.error, 1e-10);
    }
}

TEST(ProductEigenvalues, ThoseOfModesThatAreGoneAreBoundedTogether) {
  // D (1 - u v^T) with half of D underflown to 0: as many eigenvalues are exactly 0, and those that
  // are computed instead have no vectors.
  Dice dice(28);
  for (const int n : {16, 32}) {
    SCOPED_TRACE(n);
    Vector u(n), v(n), sizes(n);
    for (double& entry : u) entry = dice.uniform(-1.0, 1.0);
    for (double& entry : v) entry = dice.uniform(-1.0, 1.0);
    for (int j = 0; j < n; ++j) sizes[j] = 0.8 * std::exp(-3000.0 * j * j / (n * n));
    const Matrix jump = Matrix::Identity(n, n) - u * v.transpose();
    for (const Eigenvalue& value : product_eigenvalues({sizes.asDiagonal() * jump}))
      EXPECT_LE(value.error, 1e-10);
  }
}

// Factors X_{i+1} D_i X_i^T with rotations X_i: one direction grows tenfold at each of twelve, all
// others keep their size.
std::vector<Matrix> one_growing_direction(Dice& dice, int n, int k) {
  std::vector<Matrix> bases;
  for (int i = 0; i < k; ++i) bases.push_back(random_rotation(dice, n));
  std::vector<Matrix> factors;
  for (int i = 0; i < k; ++i) {
    Vector sizes(n);
    for (double& size : sizes) size = dice.uniform(0.95, 1.05);
    sizes[0] = 10.0;
    const auto at = static_cast<std::size_t>(i);
    factors.push_back(bases[(at + 1) % bases.size()] * sizes.asDiagonal() * bases[at].transpose());
  }
  return factors;
}

TEST(ProductEigenvalues, OnesBesideALargeOneKeepTheDigitsThatTheFormedProductLoses) {
  Dice dice(25);
  for (const int n : {2, 4, 8}) {
    SCOPED_TRACE(n);
    const std::vector<Matrix> factors = one_growing_direction(dice, n, 12);
    const std::vector<ExtendedComplex> expected = extended_eigenvalues(factors);
    const Comparison worst = compare(product_eigenvalues(factors), expected);
    EXPECT_LE(worst.of_error, 1.0);
    EXPECT_LE(worst.of_value, 1e-12);
    EXPECT_LE(worst.given, 1e-11);

    Matrix formed = Matrix::Identity(n, n);
    for (const Matrix& factor : factors) formed = (factor * formed).eval();
    EXPECT_NEAR(formed.norm(), 1e12, 1e-2 * 1e12);
    EXPECT_GE(compare(eigenvalues(formed), expected).of_value, 1e-6);
  }
}

TEST(ProductEigenvalues, PairsNextToTheUnitCircleAreToldInsideFromOutside) {
  Dice dice(26);
  for (const double excess : {-1e-11, 1e-11, -1e-9, 1e-9}) {
    // Twelve turns by 0.3 rad that grow by (1 + excess)^(1/12) each, beside one direction that
    // grows and one that shrinks.
    const int n = 4, k = 12;
    const double growth = std::exp(std::log1p(excess) / k);
    std::vector<Matrix> bases, factors;
    for (int i = 0; i < k; ++i) bases.push_back(random_rotation(dice, n));
    Matrix core = Matrix::Zero(n, n);
    core.topLeftCorner(2, 2) << std::cos(0.3), -std::sin(0.3), std::sin(0.3), std::cos(0.3);
    core.topLeftCorner(2, 2) *= growth;
    core(2, 2) = 10.0;
    core(3, 3) = 0.1;
    for (std::size_t i = 0; i < bases.size(); ++i)
      factors.push_back(bases[(i + 1) % bases.size()] * core * bases[i].transpose());
    const std::vector<Eigenvalue> values = product_eigenvalues(factors);
    ASSERT_EQ(values.size(), 4u);
    EXPECT_LE(compare(values, extended_eigenvalues(factors)).of_error, 1.0);
    for (const int i : {1, 2}) {
      const Eigenvalue& value = values[static_cast<std::size_t>(i)];
      EXPECT_NEAR(std::abs(std::arg(value.value)), kTurn - 12 * 0.3, 1e-12);
      EXPECT_LT(value.error, 0.5 * std::abs(excess) + 1e-12);
      if (std::abs(excess) > 1e-10) {
        EXPECT_GT((std::abs(value.value) - 1.0) / excess, 0.9);
      }
    }
    EXPECT_EQ(values[1].value, std::conj(values[2].value));
    EXPECT_LT(values[1].value.imag(), 0.0);
    EXPECT_EQ(values[0].value.imag(), 0.0);
  }
}

TEST(ProductEigenvalues, NeitherOverflowNorVanishOnTheWay) {
  Dice dice(29);
  std::vector<Matrix> factors, sized;
  for (int i = 0; i < 6; ++i) {
    factors.push_back(random_matrix(dice, 4));
    // Powers of two, which do not round: 3 x 2^900 and 3 x 2^-900, in this order.
    sized.push_back(factors.back() * (i < 3 ? 0x1p900 : 0x1p-900));
  }
  const std::vector<Eigenvalue> plain = product_eigenvalues(factors);
  const std::vector<Eigenvalue> scaled = product_eigenvalues(sized);
  ASSERT_EQ(plain.size(), scaled.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_EQ(plain[i].value, scaled[i].value);
    EXPECT_EQ(plain[i].error, scaled[i].error);
  }
  // A value next to the end of the range, through factors whose norms multiply beyond it.
  const Matrix turn = (Matrix(2, 2) << 0, 1, 1, 0).finished();
  const std::vector<Eigenvalue> ends =
      product_eigenvalues({Eigen::Vector2d(1e300, 1e-300).asDiagonal().toDenseMatrix(), turn,
                           Eigen::Vector2d(1e-300, 1e8).asDiagonal().toDenseMatrix(), turn});
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_NEAR(ends[0].value.real() / 1e308, 1.0, 1e-14);
}

TEST(ProductEigenvalues, CyclicPermutationsHaveRootsOfUnity) {
  for (const int n : {3, 4, 5, 7}) {
    Matrix shift = Matrix::Zero(n, n);
    for (int i = 0; i < n; ++i) shift((i + 1) % n, i) = 1.0;
    const std::vector<Eigenvalue> values =
        product_eigenvalues({shift, Matrix::Identity(n, n), Matrix::Identity(n, n)});
    ASSERT_EQ(values.size(), static_cast<std::size_t>(n));
    for (const Eigenvalue& value : values)
      EXPECT_LE(std::abs(std::pow(value.value, n) - 1.0), n * value.error * (1.0 + 1e-6));
  }
}

TEST(ProductEigenvalues, DoNotDependOnWhereTheCycleStarts) {
  Dice dice(30);
  for (int i = 0; i < 20; ++i) {
    std::vector<Matrix> factors;
    for (int m = 0; m < 5; ++m) factors.push_back(random_matrix(dice, 4));
    const std::vector<Eigenvalue> here = product_eigenvalues(factors);
    std::rotate(factors.begin(), factors.begin() + 2, factors.end());
    const std::vector<Eigenvalue> there = product_eigenvalues(factors);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t j = 0; j < here.size(); ++j)
      EXPECT_LE(std::abs(here[j].value - there[j].value), here[j].error + there[j].error);
  }
}

TEST(ProductEigenvalues, OneFactorIsAMatrix) {
  Dice dice(31);
  const Matrix matrix = random_matrix(dice, 5);
  const std::vector<Eigenvalue> product = product_eigenvalues({matrix}),
                                alone = eigenvalues(matrix);
  ASSERT_EQ(product.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(product[i].value, alone[i].value);
    EXPECT_EQ(product[i].error, alone[i].error);
  }
}

TEST(ProductEigenvalues, AreNoneWithoutFactorsOrWithEntriesThatAreNoNumbers) {
  EXPECT_TRUE(product_eigenvalues({}).empty());
  Matrix broken = Matrix::Identity(3, 3);
  broken(1, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(product_eigenvalues({Matrix::Identity(3, 3), broken}).empty());
  broken(1, 2) = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(product_eigenvalues({broken, Matrix::Identity(3, 3)}).empty());
}

}  // namespace
}  // namespace graze
