#include "graze/base/linalg/detail/invariant_blocks.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>

#include "support/systems.hpp"

namespace graze {
namespace {

constexpr double kLargest = 256.0;

std::vector<Eigen::Index> sizes(const std::vector<InvariantBlock>& blocks) {
  std::vector<Eigen::Index> list;
  for (const InvariantBlock& block : blocks) list.push_back(block.matrix.rows());
  std::sort(list.begin(), list.end());
  return list;
}

// A = sum V T W and W V = 1, to the digits that a transformation may cost.
void expect_parted(const Matrix& matrix, const std::vector<InvariantBlock>& blocks) {
  const Eigen::Index n = matrix.rows();
  Matrix sum = Matrix::Zero(n, n), one = Matrix::Zero(n, n);
  for (const InvariantBlock& a : blocks) {
    sum += a.basis * a.matrix * a.coordinates;
    one += a.basis * a.coordinates;
    for (const InvariantBlock& b : blocks) {
      if (&a == &b) continue;
      EXPECT_LE((a.coordinates * b.basis).norm(), 1e-11);
    }
  }
  EXPECT_LE((sum - matrix).norm(), 1e-11 * matrix.norm());
  EXPECT_LE((one - Matrix::Identity(n, n)).norm(), 1e-11);
}

TEST(InvariantBlocks, PartWhatIsDistinct) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    support::Dice dice(300 + seed);
    const int n = 1 + dice.pick(8);
    Matrix matrix(n, n);
    for (int j = 0; j < n; ++j) matrix.col(j) = dice.vector(n, -1.0, 1.0);
    expect_parted(matrix, invariant_blocks(matrix, kLargest));
  }
}

TEST(InvariantBlocks, KeepJordanBlocksTogetherAndLetGoOfTheRest) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    support::Dice dice(400 + seed);
    // 0 twice and -3 three times, defective; 1 -+ 5i twice, not defective; -900 alone.
    Matrix jordan = Matrix::Zero(10, 10);
    jordan(0, 1) = 1.0;
    jordan.diagonal().segment(2, 3).setConstant(-3.0);
    jordan(2, 3) = jordan(3, 4) = 1.0;
    for (const int i : {5, 7}) jordan.block(i, i, 2, 2) << 1.0, 5.0, -5.0, 1.0;
    jordan(9, 9) = -900.0;
    Matrix basis(10, 10);
    for (int j = 0; j < 10; ++j) basis.col(j) = dice.vector(10, -1.0, 1.0);
    basis += 3.0 * Matrix::Identity(10, 10);
    const Matrix matrix = basis * jordan * basis.inverse();
    const std::vector<InvariantBlock> blocks = invariant_blocks(matrix, kLargest);
    expect_parted(matrix, blocks);
    const std::vector<Eigen::Index> found = sizes(blocks);
    // The pairs may be parted or not: both are right.
    EXPECT_TRUE((found == std::vector<Eigen::Index>{1, 2, 2, 2, 3}) ||
                (found == std::vector<Eigen::Index>{1, 2, 3, 4}))
        << found.size();
  }
}

TEST(InvariantBlocks, KeepEqualPairsReal) {
  Matrix matrix = Matrix::Zero(4, 4);
  for (const int i : {0, 2}) matrix.block(i, i, 2, 2) << -0.5, 2.0, -2.0, -0.5;
  expect_parted(matrix, invariant_blocks(matrix, kLargest));
  matrix.topRightCorner(2, 2).setIdentity();  // defective
  const std::vector<InvariantBlock> blocks = invariant_blocks(matrix, kLargest);
  EXPECT_EQ(blocks.size(), 1u);
  expect_parted(matrix, blocks);
}

}  // namespace
}  // namespace graze
