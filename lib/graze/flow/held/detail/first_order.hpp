// A linear system of first order under a constant and a harmonic input,
//
//   x' = A x + load + Re(force e^{i theta}).
#pragma once

#include "graze/base/vector.hpp"

namespace graze {

// Separating modes or invariant subspaces may cost 8 of 53 bits: by vectors that nearly depend on
// each other, or by a response that cancels the motion.
inline constexpr double kLargestLoss = 256.0;

struct FirstOrderSystem {
  Matrix generator;         // A, n x n, 1/s
  Vector load, force;       // n each; zero where there is none
  double frequency = 0.0;   // of the force, rad/s; 0: none
  bool loads_vary = false;  // each arc comes with a load of its own
};

// A s, extended by states that produce the inputs, (cos theta, sin theta, 1).
Matrix extended_generator(const FirstOrderSystem& system, const Vector& load, double s);

// e^{E} x - x for such an E and columns x; a short flight's keeps its relative accuracy.
Matrix exponential_change(const Matrix& extended, const Matrix& x);

}  // namespace graze
