// Motion of a first-order linear system in those modes that are well separated: a sum of
// exponentials about a static and a harmonic response.
#pragma once

#include <functional>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/flow/exact/detail/arc_curve.hpp"
#include "graze/flow/held/detail/first_order.hpp"

namespace graze {

// Whether the modes of a system can be used: not where they are nearly dependent (defective),
// resonant with the force, too soft for the load: far slower than `quickest`, a rate of the
// structure in rad/s; or growing, beyond rounding.
bool are_usable(const ComplexModes& modes, const FirstOrderSystem& system, double quickest);

class ComplexModeFlow {
 public:
  // Some modes of `system`, k of n: x = vectors a, a = inverse x.
  ComplexModeFlow(const FirstOrderSystem& system, ComplexVector values, Eigen::MatrixXcd vectors,
                  Eigen::MatrixXcd inverse);

 private:
  friend class ComplexModeArc;

  double frequency_ = 0.0;
  ComplexVector values_;                // k
  Eigen::MatrixXcd vectors_, inverse_;  // n x k, k x n
  Matrix inverse_size_;                 // of the entries of the inverse
  Vector harmonic_size_;
  bool is_loaded_ = false;
  ComplexVector harmonic_;  // response to e^{i theta}, n
};

// One smooth piece of it; refers to its flow.
class ComplexModeArc {
 public:
  explicit ComplexModeArc(const ComplexModeFlow& flow) : flow_(&flow) {}

  // `load` replaces that of the system.
  void start(double theta, const Vector& x, const Vector& load);
  // The part of x(s) in these modes.
  Vector state(double s) const;
  // weight.x(s) as a sum of Re(size e^{rate s}), the harmonic and the static response among them.
  void each_term(const Vector& weight, const std::function<void(Complex, Complex)>& add) const;
  // Adds weight.(x(s) - x(0)) without the harmonic response to the curve; returns the weight of
  // e^{i theta} in that response.
  Complex add_to(ArcCurve<double>& curve, const Vector& weight) const;

 private:
  const ComplexModeFlow* flow_;
  double theta_ = 0.0;
  Vector rest_;  // static response, n
  ComplexVector amplitude_;
  Vector formed_from_;  // size of the terms that the amplitudes were differences of, k
};

}  // namespace graze
