// The exact motion of a damped linear system whose modes do not decouple,
//
//   y'' + C y' + K y = load + Re(force e^{i theta}),
//
// as it arises while a stop is closed under an oblique impulse law or unequal damping ratios:
// through the complex modes of its first-order form, or, where these are nearly dependent
// (defective, a free direction, or resonant with the forcing), through its matrix exponential.
#pragma once

#include <limits>
#include <string>

#include "graze/base/decompositions.hpp"
#include "graze/flow/arc_curve.hpp"

namespace graze {

// Re(size e^{rate s})
struct SignalTerm {
  Complex size, rate;
};

struct CoupledSystem {
  Matrix stiffness, damping;  // K, C, m x m
  Vector load, force;         // m each; zero where there is none
  double frequency = 0.0;     // rad/s; 0: no forcing
  Vector scale;               // rates, rad/s, m: displacements are carried as scale * y
};

class CoupledFlow {
 public:
  explicit CoupledFlow(const CoupledSystem& system);

  int size() const { return static_cast<int>(scale_.size()); }
  // A sentence where a free motion grows without bound, by more than the rounding of its
  // eigenvalue; else empty.
  std::string instability() const;
  bool has_modes() const { return has_modes_; }
  // Bounds of the matrix exponential grow with the flight: longer flights are to be cut, s.
  double longest_flight() const { return longest_flight_; }

 private:
  friend class CoupledArc;
  void use_modes(const CoupledSystem& system);

  Vector scale_;
  double frequency_ = 0.0;
  Matrix generator_;     // A of x' = A x + b, x = (scale y, y')
  Vector load_, force_;  // of x'
  double growth_ = 0.0, norm_growth_ = 0.0;
  double longest_flight_ = std::numeric_limits<double>::infinity();
  bool has_modes_ = false;
  ComplexModes modes_;
  Vector rest_;             // static response
  ComplexVector harmonic_;  // response to e^{i theta}
};

// One smooth piece of it; refers to its flow.
class CoupledArc {
 public:
  explicit CoupledArc(const CoupledFlow& flow) : flow_(&flow) {}
  void start(double theta, const Vector& y, const Vector& ydot);
  void state(double s, Vector& y, Vector& ydot) const;
  // What is added in s seconds to deviations (y; y') of the start, 2m x k, of a motion that starts
  // `delay` seconds later, k: (exp(A s) - 1) x + (d end/d start instant) delay, on (y; y').
  Matrix growth(double s, const Matrix& deviations, const Eigen::RowVectorXd& delay) const;
  ArcCurve<double> curve(const Observable<double>& observable, double window, bool from_zero) const;

  // The observable as a sum of exponentials, where the flow has modes.
  bool has_terms() const { return flow_->has_modes(); }
  std::vector<SignalTerm> terms(const Observable<double>& observable) const;
  double start_phase() const { return theta_; }
  // A bound on every rate of the motion, 1/s.
  double quickest() const { return flow_->generator_.norm() + flow_->frequency_; }

 private:
  Vector weight_of(const Observable<double>& observable) const;
  void add_modes(const Vector& weight, Complex harmonic, ArcCurve<double>& curve) const;
  ArcCurve<double>::Part matrix_part(const Vector& weight, Complex harmonic, double window) const;
  // A s, extended by (cos theta, sin theta, 1).
  Matrix extended_generator(double s) const;
  // x at s, by the exponential of the extended system.
  Vector matrix_state(double s) const;

  const CoupledFlow* flow_;
  double theta_ = 0.0;
  Vector y_, ydot_, x_;
  ComplexVector amplitude_;
};

}  // namespace graze
