// Bounds that hold, and zeros that none is missed of.
#include "graze/base/interval/detail/isolated_zeros.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace graze {
namespace {

using Form = MeanValueForm;

// Some of everything, with its derivative.
Form all_of_it(const Form& x) {
  return sine(square(x) * 3.0) / (1.5 + cosine(x)) + square_root(x + 4.0) * exponential(-x) -
         exponential_less_one(x * 0.25);
}
double value_of_it(double x) {
  return std::sin(3.0 * x * x) / (1.5 + std::cos(x)) + std::sqrt(x + 4.0) * std::exp(-x) -
         std::expm1(0.25 * x);
}
double slope_of_it(double x) {
  const double below = 1.5 + std::cos(x);
  return 6.0 * x * std::cos(3.0 * x * x) / below +
         std::sin(3.0 * x * x) * std::sin(x) / (below * below) +
         0.5 / std::sqrt(x + 4.0) * std::exp(-x) - std::sqrt(x + 4.0) * std::exp(-x) -
         0.25 * std::exp(0.25 * x);
}

TEST(MeanValueForms, HoldValuesAndSlopesOfTheirCell) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int cell = 0; cell < 2000; ++cell) {
    const double low = -3.0 + 6.0 * uniform(engine);
    const double high = low + std::pow(10.0, -8.0 * uniform(engine));
    const Form form = all_of_it(Form::variable(low, high));
    for (int i = 0; i <= 10; ++i) {
      const double x = std::min(low + (high - low) * i / 10.0, high);
      EXPECT_TRUE(form.value.contains(value_of_it(x))) << low << " " << high;
      EXPECT_TRUE(form.slope.contains(slope_of_it(x))) << low << " " << high;
    }
  }
}

TEST(MeanValueForms, TightenWithTheSquareOfTheCell) {
  const auto excess = [](double width) {
    const Form form = all_of_it(Form::variable(0.7, 0.7 + width));
    return form.value.width() - std::abs(value_of_it(0.7 + width) - value_of_it(0.7));
  };
  EXPECT_LT(excess(1e-3) / excess(1e-2), 0.02);
  EXPECT_LT(excess(1e-4) / excess(1e-3), 0.02);
}

TEST(IsolatedZeros, OfASineWithARisingFrequency) {
  // sin(x^2) over [1, 100]: x = sqrt(k pi), k = 1..3183, the last ones 0.016 apart.
  const auto f = [](double low, double high) {
    return std::optional(sine(square(low < high ? Form::variable(low, high) : Form(low))));
  };
  const IsolatedZeros found = isolated_zeros(f, 1.0, 100.0, 1'000'000);
  EXPECT_EQ(found.undecided, 0);
  EXPECT_EQ(found.first_sign, 1);
  ASSERT_EQ(found.zeros.size(), 3183u);
  for (std::size_t k = 1; k <= found.zeros.size(); ++k)
    EXPECT_NEAR(found.zeros[k - 1], std::sqrt(static_cast<double>(k) * std::numbers::pi), 1e-12);
}

TEST(IsolatedZeros, AsNearAsTheSquareRootOfRounding) {
  // (x - 1/3)^2 = e^2 with e = 1e-6: a pair 2e-6 apart.
  const auto f = [](double low, double high) {
    const Form x = low < high ? Form::variable(low, high) : Form(low);
    return std::optional(square(x - 1.0 / 3.0) - 1e-12);
  };
  const IsolatedZeros found = isolated_zeros(f, 0.0, 1.0, 100'000);
  EXPECT_EQ(found.undecided, 0);
  ASSERT_EQ(found.zeros.size(), 2u);
  EXPECT_NEAR(found.zeros[0], 1.0 / 3.0 - 1e-6, 1e-10);
  EXPECT_NEAR(found.zeros[1], 1.0 / 3.0 + 1e-6, 1e-10);
}

TEST(IsolatedZeros, ADoubleZeroIsUndecidedAndSaysWhere) {
  const auto f = [](double low, double high) {
    return std::optional(square((low < high ? Form::variable(low, high) : Form(low)) - 1.0 / 3.0));
  };
  const IsolatedZeros found = isolated_zeros(f, 0.0, 1.0, 100'000);
  EXPECT_GE(found.undecided, 1);
  EXPECT_LT(found.widest, 1e-15);
}

TEST(IsolatedZeros, ABudgetLeavesTheWidestCellsUndecided) {
  const auto f = [](double low, double high) {
    return std::optional(sine(square(low < high ? Form::variable(low, high) : Form(low))));
  };
  const IsolatedZeros found = isolated_zeros(f, 1.0, 100.0, 500);
  EXPECT_GT(found.undecided, 100);
  EXPECT_GT(found.widest, 0.1);
  EXPECT_LT(found.evaluations, 5000);  // those at points included
}

// A function that cannot be evaluated at the start of its range: x - 1/3 beyond 0.
TEST(IsolatedZeros, ABadPointAtTheStartHidesNothing) {
  const auto f = [](double low, double high) -> std::optional<Form> {
    if (low <= 0.0) return {};
    return (low < high ? Form::variable(low, high) : Form(low)) - 1.0 / 3.0;
  };
  const IsolatedZeros found = isolated_zeros(f, 0.0, 1.0, 100'000);
  EXPECT_EQ(found.first_sign, -1);
  ASSERT_EQ(found.zeros.size(), 1u);
  EXPECT_NEAR(found.zeros[0], 1.0 / 3.0, 1e-15);
  EXPECT_EQ(found.undecided, 1);
  EXPECT_LT(found.widest, 1e-15);
  EXPECT_LT(found.evaluations, 500);
}

}  // namespace
}  // namespace graze
