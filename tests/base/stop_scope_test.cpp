// Long computations end once they are asked to, and say that less is known; short ones are
// finished.
#include "graze/base/detail/stop_scope.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "graze/base/interval/detail/isolated_zeros.hpp"
#include "graze/base/linalg/detail/product_eigenvalues.hpp"
#include "graze/base/parallel.hpp"

namespace graze {
namespace {

const std::atomic<bool> kAsked{true};
const StopSignal kGiven{&kAsked, {}};

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

TEST(StopScope, LeavesShortComputationsAsTheyAre) {
  const std::vector<Matrix> factors = two_factors(8);
  const std::vector<Eigenvalue> whole = product_eigenvalues(factors);
  const StopScope scope(kGiven);
  const std::vector<Eigenvalue> asked = product_eigenvalues(factors);
  ASSERT_EQ(asked.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(asked[i].value, whole[i].value);
    EXPECT_EQ(asked[i].error, whole[i].error);
  }
}

TEST(StopScope, EndsEigenvaluesOfManyModes) {
  const std::vector<Matrix> factors = two_factors(200);
  const StopScope scope(kGiven);
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
  const StopScope scope(kGiven);
  const IsolatedZeros found = isolated_zeros(undecidable, 0.0, 1.0, kMostCells);
  EXPECT_TRUE(found.zeros.empty());
  EXPECT_GT(found.undecided, 0);
  EXPECT_LT(evaluations, kMostCells / 16);
}

}  // namespace
}  // namespace graze
