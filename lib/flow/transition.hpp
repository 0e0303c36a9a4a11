// Derivatives of the exact flow: where an arc ends, and how its end moves with its start, its start
// phase and the coefficients of the system. Analytic throughout.
#pragma once

#include "graze/flow/exact_flow.hpp"

namespace graze {

// The flow matrix is block diagonal, one 2 x 2 block per mode:
//   q_end = qq q + qv qdot,   qdot_end = vq q + vv qdot.
struct FlowMatrix {
  Vector qq, qv, vq, vv;

  // The matrix times a dense one whose rows are (q; qdot), 2N x m.
  Matrix times(const Matrix& right) const;
};

struct Transition {
  State end;
  State end_rate;    // time derivative at the end: (q', q'')
  FlowMatrix flow;   // d end/d start
  State phase_rate;  // d end/d start phase, at fixed duration; zero without forcing
};

// (q', q'') of the system at forcing phase theta.
State vector_field(const System& system, const State& state, double theta);

// Flow over s seconds from `start` at forcing phase theta. s may be negative.
Transition transition(const System& system, const ExactFlow<double>& flow, const State& start,
                      double theta, double s);

// Response from rest to the constant load alone, after s seconds; zero without one.
State load_response(const System& system, const ExactFlow<double>& flow, double s);

// Derivative of the end by a parameter along `tangent` (see system_tangent), where start, start
// phase and end phase are kept: the duration is (end phase - start phase)/frequency and so moves
// with the frequency. Requires forcing.
State end_tangent(const System& system, const System& tangent, const ExactFlow<double>& flow,
                  const State& start, double theta, double s);

}  // namespace graze
