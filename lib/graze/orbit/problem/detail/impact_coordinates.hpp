// The unknowns of orbits of masses and springs between rigid stops. With a parameter modes may
// change their sign or their order, so that the state before an impact is that of the masses,
// u = Phi q, u' = Phi q'. The equations r(x) are those of the modes, s(y),
//
//   x = T y,   r = T s,
//
// T the block diagonal matrix of 1 for the phase (in r: for the gap of the contact) and of Phi, in
// the units of both.
#pragma once

#include "graze/system/scale.hpp"

namespace graze {

class ImpactCoordinates {
 public:
  // `own`: Phi, the displacements of the masses by those of the modes.
  ImpactCoordinates(const Matrix& own, const MotionScale& scale);

  // T y, T^-1 x, T^T w and T^-T g, of columns.
  template <class Columns>
  Columns turned(const Columns& y) const {
    return blocks(y, shape_q_, shape_v_, 1.0);
  }
  template <class Columns>
  Columns back(const Columns& x) const {
    return blocks(x, inverse_q_, inverse_v_, 1.0);
  }
  template <class Columns>
  Columns turned_covector(const Columns& w) const {
    return blocks(w, shape_q_.transpose(), shape_v_.transpose(), 1.0);
  }
  template <class Columns>
  Columns back_covector(const Columns& g) const {
    return blocks(g, inverse_q_.transpose(), inverse_v_.transpose(), 1.0);
  }
  // The rate of T y at fixed y, along a tangent of the system.
  template <class Columns>
  Columns rate(const System& tangent, const Columns& y) const {
    const Matrix& own = *tangent.coordinates();
    return blocks(y, own * unit_q_, own * unit_v_.asDiagonal(), 0.0);
  }
  // T A T^-1 of a square matrix.
  Matrix similar(const Matrix& a) const {
    return turned(Matrix(back_covector(Matrix(a.transpose())).transpose()));
  }

 private:
  template <class Columns>
  static Columns blocks(const Columns& of, const Matrix& q, const Matrix& v, double phase) {
    const Eigen::Index n = q.rows();
    Columns all(of.rows(), of.cols());
    for (Eigen::Index at = 0; at < of.rows(); at += 2 * n + 1) {
      all.row(at) = phase * of.row(at);
      all.middleRows(at + 1, n) = q * of.middleRows(at + 1, n);
      all.middleRows(at + 1 + n, n) = v * of.middleRows(at + 1 + n, n);
    }
    return all;
  }

  double unit_q_;  // of q in that of u, likewise of each q'
  Vector unit_v_;
  Matrix shape_q_, shape_v_, inverse_q_, inverse_v_;
};

}  // namespace graze
