// The exact motion of a damped linear system whose modes do not decouple,
//
//   y'' + C y' + K y = load + Re(force e^{i theta}),
//
// as it arises where damping couples the natural modes, while a stop is closed under an oblique
// impulse law or unequal damping ratios, or beside springs: in its first-order form, by complex
// modes where these are well separated; otherwise split along its invariant subspaces, so that only
// those modes need matrix exponentials that are defective, free, resonant with the forcing, or
// growing.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "graze/flow/exact/detail/arc_curve.hpp"
#include "graze/flow/held/detail/complex_mode_flow.hpp"
#include "graze/flow/held/detail/exponential_flow.hpp"
#include "graze/flow/held/detail/generator_parts.hpp"

namespace graze {

struct CoupledSystem {
  Matrix stiffness, damping;  // K, C, m x m
  Vector load, force;         // m each; zero where there is none
  double frequency = 0.0;     // rad/s; 0: no forcing
  Vector scale;               // rates, rad/s, m: displacements are carried as scale * y
  bool loads_vary = false;    // each arc comes with a load of its own
};

class CoupledFlow {
 public:
  explicit CoupledFlow(const CoupledSystem& system);

  // A sentence where a free motion grows without bound, by more than the rounding of its
  // eigenvalue; else empty.
  std::string instability() const;
  // Longest flight without a cut, s: bounds of matrix exponentials grow with the flight.
  double longest_flight() const;

  // The first-order form, x = (scale y, y').
  const FirstOrderSystem& first_order() const { return whole_; }
  const Vector& scale() const { return scale_; }

 private:
  friend class CoupledArc;
  void split(const std::vector<GeneratorPart>& parts, double quickest);

  Vector scale_;
  FirstOrderSystem whole_;
  std::vector<ComplexModeFlow> modes_;  // one or none
  std::vector<ExponentialFlow> exponentials_;
  double growth_ = 0.0;
};

// One smooth piece of it; refers to its flow.
class CoupledArc {
 public:
  explicit CoupledArc(const CoupledFlow& flow);
  void start(double theta, const Vector& y, const Vector& ydot);
  // For a system whose loads vary: displacements count from y, where `load` is the load together
  // with the force of the stiffness. So nothing large has to cancel in motions that are small
  // against y.
  void start_from(double theta, const Vector& y, const Vector& ydot, const Vector& load);
  void state(double s, Vector& y, Vector& ydot) const;
  // Growth over s seconds of deviations (y; y') of the start, 2m x k, of a motion that starts
  // `delay` seconds later, k: (exp(A s) - 1) x + (d end/d start instant) delay, on (y; y').
  Matrix growth(double s, const Matrix& deviations, const Eigen::RowVectorXd& delay) const;
  ArcCurve<double> curve(const Observable<double>& observable, double window, bool from_zero) const;
  // An observable as a sum of Re(size e^{rate s}); returns false, without a call of `add`, where
  // some of the motion needs matrix exponentials.
  bool each_term(const Observable<double>& observable,
                 const std::function<void(Complex, Complex)>& add) const;

  const CoupledFlow& flow() const { return *flow_; }
  double start_phase() const { return theta_; }
  const Vector& start_state() const { return x_; }  // x = (scale y, y'), y from the origin
  const Vector& origin() const { return origin_; }
  const Vector& load() const { return load_; }  // on x

 private:
  void start_modes();
  Vector weight_of(const Observable<double>& observable) const;  // on x

  const CoupledFlow* flow_;
  double theta_ = 0.0;
  Vector y_, ydot_, origin_, x_, load_;
  std::vector<ComplexModeArc> modes_;
  std::vector<ExponentialArc> exponentials_;
};

}  // namespace graze
