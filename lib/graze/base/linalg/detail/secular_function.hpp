// The secular equation of a product of jumps of low rank and flows in blocks,
//
//   M = F_k S_k .. F_1 S_1,   S_i = I + P_i Q_i^T,
//
// F_i block diagonal with a 2 x 2 block for each mode. F_ji denotes the flows from the i-th to the
// one before the j-th, on round the cycle where i >= j, and D_i = F_ii all of them from the i-th
// on. An mu that is no eigenvalue of D_1 is one of M exactly where
//
//   det G(mu) = det(mu - M)/det(mu - D_1) = 0,
//   G_ji = delta_ji - c_ji Q_j^T F_ji (mu - D_i)^-1 P_i,     c_ji = mu for i < j, 1 otherwise,
//
// a matrix as large as all ranks together. Each mode enters its entries by a fraction over (mu -
// l1)(mu - l2) with the eigenvalues of its block of D_1, the poles.
#pragma once

#include <vector>

#include "graze/base/vector.hpp"

namespace graze {

// S and then F of n modes, entries in the order (q; q').
struct JumpAndFlow {
  Matrix from, to;        // P, Q: 2n x r
  Vector qq, qv, vq, vv;  // the blocks of F: n each
  Vector uncertainty;     // n: how far each block may be from the one that is meant, in eps |block|

  double norm() const;  // |F S| (Frobenius)
};

// The eigenvalues of a mode's block of all flows: real, or conjugate.
struct PolePair {
  Complex first, second;
};

class SecularFunction {
 public:
  // Refers to the factors, at least one, all of the same number of modes.
  explicit SecularFunction(const std::vector<JumpAndFlow>& factors);

  Eigen::Index modes() const { return mean_.size(); }
  const std::vector<PolePair>& poles() const { return poles_; }
  // Frobenius norm of a mode's block of D_1.
  double flow_norm(Eigen::Index mode) const { return flow_norm_[mode]; }
  // The eigenvalues of the mode's own block of M where the other modes do not move.
  PolePair alone(Eigen::Index mode) const;

  // From now on the mode's poles count as known eigenvalues of M; p below is divided by their
  // factors.
  void leave_out(Eigen::Index mode);

  // p'/p of p(mu) = det(mu - M) over the product of mu - l for the poles left out. Not finite at a
  // pole, or where G is singular.
  Complex logarithmic_slope(Complex mu) const;
  double log_modulus(Complex mu) const;        // log |p|
  double trace() const;                        // of M
  double jump_norm(std::size_t factor) const;  // |S_i| (Frobenius)

  // How far an eigenvalue moves, to first order, where every S_i is changed by `roundings` eps
  // |S_i| and every block of F_i by its uncertainty and as many roundings as are in a product of
  // two by two. Infinite, or not a number, where it is defective.
  double first_order_error(Complex mu, double roundings) const;

 private:
  struct Values {
    Eigen::MatrixXcd g, slope;  // G, dG/dmu
    Complex poles;              // sum of 1/(mu - l) of those not left out
  };
  Values evaluate(Complex mu) const;
  void add_entries(std::size_t row, std::size_t column);
  ComplexVector over_poles(Complex mu, const ComplexVector& x, bool transposed) const;

  const std::vector<JumpAndFlow>& factors_;
  std::vector<Eigen::Index> first_;  // row of G where each factor's begin; one more: its size
  std::vector<PolePair> poles_;
  Vector mean_, flow_norm_;
  // K_i = D_i - mean, whose square is a multiple of 1, of every factor: rows qq, qv, vq, vv; 4 x n.
  std::vector<Matrix> centred_;
  // Entry e of G of mode m is delta - c (constant + mu linear)/((mu - l1)(mu - l2)); c = 1 of the
  // first `direct_` entries, mu of the others.
  Matrix constant_, linear_;           // entries x n
  std::vector<Eigen::Index> entries_;  // where in G, counted by columns
  Eigen::Index direct_ = 0;
  Vector counted_;  // n: 1, or 0 where the mode is left out
};

}  // namespace graze
