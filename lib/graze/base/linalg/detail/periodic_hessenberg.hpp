// Real orthogonal steps towards the periodic Schur form of A_k .. A_1 (periodic_schur.hpp):
// singular factors split off, periodic Hessenberg form, implicit double-shift QR steps with
// deflation, down to blocks of one or two rows.
#pragma once

#include <vector>

#include "graze/base/stop_scope.hpp"
#include "graze/base/vector.hpp"

namespace graze {

class PeriodicHessenberg {
 public:
  explicit PeriodicHessenberg(std::vector<Matrix> factors);

  // Carries all steps out; false when an eigenvalue takes more than 120 of them, or it
  // was asked to stop (stop_scope.hpp).
  bool reduce();

  // After reduce(): the first factor is block upper triangular, the others upper triangular.
  const std::vector<Matrix>& factors() const { return factors_; }
  // First rows of the 2 x 2 blocks.
  const std::vector<Eigen::Index>& blocks() const { return blocks_; }

 private:
  using Index = Eigen::Index;

  void reflect(std::size_t image, Index first, Index size, Index column, Index rows);
  void split_off_zeros();
  bool split_off(std::size_t factor);
  bool to_hessenberg();
  bool iterate();
  Index window_start(Index last);
  Eigen::Vector3d double_shift(Index first, Index last) const;
  void step(Index first, Index last, const Eigen::Vector3d& start);
  void triangularise_bulge(Index row, Index size, Index last);
  std::size_t next(std::size_t factor) const { return (factor + 1) % factors_.size(); }

  std::vector<Matrix> factors_;
  Index n_ = 0;
  Index active_ = 0;  // leading rows whose product is not known to be singular
  std::vector<Index> blocks_;
  Vector reflector_, projection_;  // workspace
};

}  // namespace graze
