// How directions grow along a product of matrices: Lyapunov exponents.
//
// k orthonormal directions are carried through the next factors, and made orthonormal again in
// their order, A Q = Q' R. The means of ln |R_ii| tend to the exponents, largest first, for almost
// every start: the first i directions span the volume that grows most (G. Benettin, L. Galgani,
// A. Giorgilli, J.-M. Strelcyn, Meccanica 15 (1980) 9-20 and 21-30; I. Shimada, T. Nagashima, Prog.
// Theor. Phys. 61 (1979) 1605-1616).
//
// A factor may map directions to zero: an impact without rebound, or rest on a stop, removes any
// difference between neighbouring motions in them, for good. Their exponents are minus infinity,
// and they are carried no further.
#pragma once

#include "graze/base/vector.hpp"

namespace graze {

class GrowingDirections {
 public:
  explicit GrowingDirections(Eigen::Index size);  // all of them

  // n x k: what the next factor is to be applied to.
  const Matrix& now() const { return directions_; }
  // `image`: the images of the directions under a factor of at most this rank. A factor of full
  // rank keeps all of them. Otherwise a direction is lost when its image is zero or lies, to
  // rounding, in the span of the images before it, and so are those that come after the first
  // `rank`. Returns ln |R_ii|, n, minus infinity for lost directions.
  Vector carry(const Matrix& image, Eigen::Index rank);
  Vector carry(const Matrix& image) { return carry(image, image.rows()); }
  Eigen::Index lost() const { return directions_.rows() - directions_.cols(); }

 private:
  Matrix directions_;
};

// The mean of a sequence of values and its standard error, from the means of blocks. The blocks are
// long enough to be uncorrelated where the sequence is mixing.
class BlockMean {
 public:
  // `expected`: number of values; they are cut into 32 blocks.
  explicit BlockMean(long long expected);
  void add(const Vector& value);
  long long count() const { return count_; }
  Vector mean() const;
  Vector standard_error() const;  // not finite with fewer than two blocks

 private:
  static constexpr long long kBlocks = 32;
  long long length_, count_ = 0, blocks_ = 0;
  Vector sum_, block_, block_sum_, block_squares_;
};

}  // namespace graze
