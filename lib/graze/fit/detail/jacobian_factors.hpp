// The singular values of a derivative J (m values x n parameters), its columns first scaled to
// length one, so that units do not matter:
//
//   J = U S V^T D,   D the lengths of the columns.
//
// A direction of the parameters whose singular value is below the error of J changes none of the
// measured values: the data do not determine it.
#pragma once

#include <vector>

#include "graze/base/vector.hpp"

namespace graze {

class JacobianFactors {
 public:
  // `error`: of the columns, relative to their lengths; at least the rounding max(m, n) eps.
  JacobianFactors(const Matrix& jacobian, double error);

  Eigen::Index rank() const { return rank_; }
  // The shortest step that reduces |r + J p| most, without the directions that are not determined.
  Vector step(const Vector& residual) const;
  // (J^T J)^-1; requires full rank.
  Matrix inverse_normal() const;
  // Parameters (from 0) that take part in a direction that is not determined, one list a direction.
  std::vector<std::vector<Eigen::Index>> untold() const;

 private:
  Vector lengths_;  // n
  Matrix left_;     // U, m x k
  Vector values_;   // S, k, falling
  Matrix right_;    // V, n x k
  Eigen::Index rank_ = 0;
};

}  // namespace graze
