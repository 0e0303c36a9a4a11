// Computations end once their time is over, and say that less is known.
#include "graze/base/stop_scope.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "graze/base/interval/detail/isolated_zeros.hpp"
#include "graze/base/linalg/detail/product_eigenvalues.hpp"
#include "graze/base/parallel.hpp"

namespace graze {
namespace {

const std::atomic<bool> kAsked{true};
const StopSignal kGiven{&kAsked, {}};
constexpr std::chrono::milliseconds kNone{0};
constexpr std::chrono::hours kLong{1};

// Entries without a pattern, the same on every machine.
std::vector<Matrix> two_factors(Eigen::Index n) {
  std::vector<Matrix> factors(2, Matrix(n, n));
  unsigned state = 1;
  for (Matrix& factor : factors)
    for (Eigen::Index i = 0; i < factor.size(); ++i) {
      state = state * 1664525U + 1013904223U;
      factor.data()[i] = static_cast<double>(state >> 8) / 16777216.0 - 0.5;
    }
  return factors;
}

TEST(StopScope, IsHandedToThreads) {
  std::vector<int> asked(8, 0);
  const StopScope scope(kGiven);
  for_each_index(asked.size(), 2,
                 [&](std::size_t i) { asked[i] = StopScope::current().requested() ? 1 : 0; });
  EXPECT_EQ(asked, std::vector<int>(8, 1));
}

TEST(StopScope, EndsWithItsBlock) {
  {
    const StopScope scope(kGiven);
    EXPECT_TRUE(StopScope::current().requested());
    {
      const StopScope grace(StopSignal{});
      EXPECT_FALSE(StopScope::current().requested());
    }
    EXPECT_TRUE(StopScope::current().requested());
  }
  EXPECT_FALSE(StopScope::current().requested());
}

bool is_soon_over() {
  using Clock = std::chrono::steady_clock;
  for (const auto latest = Clock::now() + std::chrono::seconds(60); Clock::now() < latest;) {
    if (StopScope::is_over()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

TEST(StopScope, IsOverAGraceAfterTheSignal) {
  EXPECT_FALSE(StopScope::is_over());
  {
    const StopScope scope(kGiven, kLong);
    EXPECT_TRUE(StopScope::current().requested());
    EXPECT_FALSE(StopScope::is_over());
  }
  std::atomic<bool> asked{false};
  {
    const StopScope scope(StopSignal{&asked, {}});
    EXPECT_FALSE(StopScope::is_over());
    asked = true;
    EXPECT_TRUE(is_soon_over());
    const StopScope other(StopSignal{});
    EXPECT_FALSE(StopScope::is_over());
  }
  EXPECT_FALSE(StopScope::is_over());
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(5);
  const StopScope scope(StopSignal{nullptr, deadline});
  EXPECT_TRUE(is_soon_over());
  EXPECT_GE(std::chrono::steady_clock::now(), deadline + StopScope::kGrace);
  std::vector<int> over(4, 0);
  for_each_index(over.size(), 2, [&](std::size_t i) { over[i] = StopScope::is_over() ? 1 : 0; });
  EXPECT_EQ(over, std::vector<int>(4, 1));
}

TEST(StopScope, LeavesComputationsWithinTheGraceAsTheyAre) {
  const std::vector<Matrix> factors = two_factors(8);
  const std::vector<Eigenvalue> whole = product_eigenvalues(factors);
  const StopScope scope(kGiven, kLong);
  const std::vector<Eigenvalue> asked = product_eigenvalues(factors);
  ASSERT_EQ(asked.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(asked[i].value, whole[i].value);
    EXPECT_EQ(asked[i].error, whole[i].error);
  }
}

TEST(StopScope, EndsEigenvaluesOfManyModes) {
  const std::vector<Matrix> factors = two_factors(200);
  const StopScope scope(kGiven, kNone);
  EXPECT_TRUE(product_eigenvalues(factors).empty());
}

// Nothing is known of this function, so that every cell would be halved until the budget is spent.
TEST(StopScope, LeavesBoundsOnZerosOpen) {
  long long evaluations = 0;
  const BoundedFunction undecidable = [&](double, double) {
    ++evaluations;
    return std::optional<MeanValueForm>();
  };
  constexpr long long kMostCells = 1 << 20;
  const StopScope scope(kGiven, kNone);
  const IsolatedZeros found = isolated_zeros(undecidable, 0.0, 1.0, kMostCells);
  EXPECT_TRUE(found.zeros.empty());
  EXPECT_GT(found.undecided, 0);
  EXPECT_LT(evaluations, kMostCells / 16);
}

}  // namespace
}  // namespace graze
