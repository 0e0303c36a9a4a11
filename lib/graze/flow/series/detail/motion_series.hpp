// The motion of many modes over a short step as a power series in time,
//
//   q(t) = sum_k c_k (t/u)^k,   (k+2)(k+1) c_{k+2} = u^2 [g_k - 2 delta (k+1) c_{k+1}/u - w^2 c_k]
//                                                    - B mu_k,
//
// free (no B) or held by closed stops whose impulses act along their rows: their contact forces mu
// keep B^T q = a, so that B^T c_{k+2} = 0 gives mu_k by a system of their number. A coefficient
// costs O(N m), and a set of closed stops needs no preparation: with many modes, finding the modes
// of the held structure takes O(N^3), and sticking phases often last a fraction of the shortest
// modal period.
//
// The remainder is bounded without looking ahead. Derivative P of the motion satisfies the same
// equation, without load; closed stops do no work on it, since B^T q^(P+1) = 0, and damping takes
// energy: (|q^(P+1)|^2 + |w q^(P)|^2)/2 grows by the harmonic force only,
//
//   sqrt(|q^(P+1)|^2 + |w q^(P)|^2)(t) <= sqrt(..)(0) + |f| W^P t.
#pragma once

#include <span>
#include <vector>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/flow/exact/detail/exact_flow.hpp"

namespace graze {

// A polynomial in t/u, known to noise + noise_rate t/u; its truncation error is at most remainder
// (t/u)^(number of coefficients).
struct BoundedSeries {
  std::span<const double> coefficients;
  double remainder = 0.0, noise = 0.0, noise_rate = 0.0;
};

class MotionSeries {
 public:
  // `rows`: B of the stops that hold, N x m, linearly independent; with no column it moves freely.
  // Coefficients up to `order` + 1 are formed.
  MotionSeries(const LinearSystem<double>& modes, Matrix rows, int order);

  // Expands the motion about the state at forcing phase theta.
  void expand(double theta, const Vector& q, const Vector& qdot);

  int order() const { return order_; }               // P
  double unit() const { return unit_; }              // u, s
  const Matrix& coefficients() const { return c_; }  // c_k, N x (P + 2)
  const Matrix& forces() const { return mu_; }       // contact forces, N, m x P, in powers of t/u
  // sqrt(|q^(k+1)|^2 + |w q^(k)|^2) u^k/k! at the start, k = 0..P: the size of derivative k.
  double size(int k) const;
  // A bound on size(P) for all t <= kLongest u.
  double last_size() const { return last_size_; }
  static constexpr double kLongest = 8.0;

  // The longest step, in u, over which the motion is known to `part` of its size.
  double step(double part) const;
  // A polynomial of degree P in t/u for b.q, |b| = 1, has an error of at most this times
  // (t/u)^(P+1).
  double remainder() const { return last_size_ * unit_ / (order_ + 1); }
  // The same for contact force i and its polynomial of degree P - 1: times (t/u)^P.
  double force_remainder(int i) const;
  // sqrt(|2 delta s_i|^2 + |w s_i|^2), mu_i = s_i.(free acceleration).
  double force_weight(int i) const { return force_weight_[i]; }
  // |s_i.f|, N; 0 without forcing.
  double force_push(int i) const;
  // s_i| . |..|: the sum of the sizes of the terms of mu_i at the start, for its rounding.
  double force_noise(int i) const;

  void state(double tau, Vector& q, Vector& qdot) const;
  // Velocities at each of these t/u, N x count.
  Matrix velocities(std::span<const double> taus) const;

  // gap - row.q over `tau` units, kept in `storage`. Where it starts at a zero of multiplicity n >
  // 0, it is divided by (t/u)^n and begins with the coefficient that is known to leave zero.
  // `norm`: |row|.
  BoundedSeries gap(const Eigen::Ref<const Vector>& row, double norm, double gap, int multiplicity,
                    double tau, std::vector<double>& storage) const;
  // Contact force i; its release is a value that is certainly below zero.
  BoundedSeries force(int i, std::vector<double>& storage) const;

  // Contact forces in a given state, m.
  Vector forces_at(double theta, const Vector& q, const Vector& qdot) const;
  // Projects the state onto the stops that hold, from which rounding has moved it.
  void settle(const Vector& gaps, Vector& q, Vector& qdot) const;

 private:
  void free_terms(int k, Vector& terms) const;

  int order_;
  double unit_ = 0.0;
  Vector omega_, delta_;
  Vector stiffness_, damping_;           // (w u)^2, 2 delta u
  Vector load_, amplitude_;              // u^2 times; empty: none
  double turn_ = 0.0, frequency_ = 0.0;  // W u, W
  Matrix rows_, shares_;                 // B, and S with mu = S^T (free acceleration): N x m
  Vector force_weight_;
  double theta_ = 0.0, last_size_ = 0.0;
  Matrix c_, mu_;
};

// Result of the search for the first zero in (0, tau].
struct SeriesZero {
  double clear = 0.0;    // it is positive by more than noise up to there
  bool crosses = false;  // and falls through zero at once behind, at `zero`
  double zero = 0.0;
};
// Requires a series that starts positive, or with its zero at the start divided out. `resolved`:
// how near `clear` is brought to a zero, as a part of tau.
SeriesZero first_zero(const BoundedSeries& series, double tau, double resolved);

}  // namespace graze
