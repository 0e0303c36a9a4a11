// The gap at a stop, gap - row.q, and its rounding error.
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

// Depth beyond the surface of a stop, m; zero within the rounding of the gap.
template <class Real>
Real depth_value(const Eigen::Matrix<Real, Eigen::Dynamic, 1>& row,
                 const Eigen::Matrix<Real, Eigen::Dynamic, 1>& q, const Real& gap) {
  using std::abs;
  const GapValue<Real> at = gap_value(row, q, gap);
  return abs(at.value) <= at.rounding ? Real(0) : Real(-at.value);
}

// Rounding error of the approach speed row.q', m/s: so many roundings of its terms.
inline constexpr int kSpeedRoundings = 8;

template <class Real>
Real speed_rounding(const Eigen::Matrix<Real, Eigen::Dynamic, 1>& row,
                    const Eigen::Matrix<Real, Eigen::Dynamic, 1>& qdot) {
  return kSpeedRoundings * std::numeric_limits<Real>::epsilon() *
         row.cwiseAbs().dot(qdot.cwiseAbs());
}

}  // namespace graze
