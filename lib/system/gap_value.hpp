// The gap at a stop, gap - row.q, and how far its rounding reaches.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace graze {

template <class Real>
struct GapValue {
  Real value = 0;     // m
  Real rounding = 0;  // m: one eps for every product and every sum, of its size
};

template <class Real>
GapValue<Real> gap_value(const Eigen::Matrix<Real, Eigen::Dynamic, 1>& row,
                         const Eigen::Matrix<Real, Eigen::Dynamic, 1>& q, const Real& gap) {
  using std::abs;
  Real reach = 0, size = abs(gap);
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const Real part = row[j] * q[j];
    reach += part;
    size += abs(part);
  }
  const Real eps = std::numeric_limits<Real>::epsilon();
  return {gap - reach, Real(static_cast<int>(q.size()) + 2) * eps * size};
}

}  // namespace graze
