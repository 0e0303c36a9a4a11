#include "graze/base/linalg/detail/growing_directions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {
namespace {

constexpr double kLost = -std::numeric_limits<double>::infinity();
// Roundings in what is left of a column once the others are taken out, each of the column's size.
constexpr double kRoundings = 16.0;

}  // namespace

GrowingDirections::GrowingDirections(Eigen::Index size)
    : directions_(Matrix::Identity(size, size)) {}

// Gram and Schmidt, twice over, which is enough (L. Giraud, J. Langou, M. Rozloznik, J. van den
// Eshof, Numer. Math. 101 (2005) 87-100).
Vector GrowingDirections::carry(const Matrix& image, Eigen::Index rank) {
  const Eigen::Index n = directions_.rows();
  const double rounding =
      kRoundings * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
  Vector growth = Vector::Constant(n, kLost);
  Matrix kept(n, image.cols());
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < image.cols() && count < rank; ++i) {
    Vector column = image.col(i);
    const double size = column.norm();
    for (int pass = 0; pass < 2; ++pass) {
      const Vector parts = kept.leftCols(count).transpose() * column;
      column -= kept.leftCols(count) * parts;
    }
    const double left = column.norm();
    if (!(left > 0.0) || (rank < n && left <= rounding * std::max(size, 1.0))) continue;
    kept.col(count) = column / left;
    growth[count++] = std::log(left);
  }
  directions_ = kept.leftCols(count);
  return growth;
}

BlockMean::BlockMean(long long expected) : length_(std::max<long long>(expected / kBlocks, 1)) {}

void BlockMean::add(const Vector& value) {
  if (count_ == 0) sum_ = block_ = block_sum_ = block_squares_ = Vector::Zero(value.size());
  sum_ += value;
  block_ += value;
  if (++count_ % length_ != 0) return;
  block_ /= static_cast<double>(length_);
  block_sum_ += block_;
  block_squares_ += block_.cwiseAbs2();
  ++blocks_;
  block_.setZero();
}

Vector BlockMean::mean() const { return sum_ / static_cast<double>(count_); }

Vector BlockMean::standard_error() const {
  const auto blocks = static_cast<double>(blocks_);
  const Vector mean = block_sum_ / blocks;
  const Vector variance = (block_squares_ / blocks - mean.cwiseAbs2()).cwiseMax(0.0);
  return (variance / (blocks - 1.0)).cwiseSqrt();
}

}  // namespace graze
