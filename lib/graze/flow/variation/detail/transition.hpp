// Derivatives of the exact flow: the end of an arc, and its derivatives by its start, its start
// phase and the coefficients of the system. Analytic throughout.
#pragma once

#include "graze/flow/exact/detail/exact_flow.hpp"
#include "graze/flow/exact/detail/free_basis.hpp"

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

// One mode of a transition.
struct ModeTransition {
  double q = 0.0, qdot = 0.0;                        // at the end
  double acceleration = 0.0;                         // there
  double qq = 0.0, qv = 0.0, vq = 0.0, vv = 0.0;     // d end/d start
  double phase_rate_q = 0.0, phase_rate_qdot = 0.0;  // d end/d start phase, at fixed duration
  FreeBasis<double> basis{};                         // of the free response over the arc
};

// The transitions over s seconds from forcing phase theta, mode by mode and without allocating, for
// loops that do not store them. Refers to the system and to its flow. s may be negative.
class ModalTransitions {
 public:
  ModalTransitions(const System& system, const ExactFlow<double>& flow, double theta, double s);

  // Mode j from (q, qdot).
  ModeTransition from(Eigen::Index j, double q, double qdot) const;
  // Derivative (of q, of qdot) of the end of transition `of`, see end_tangent().
  Eigen::Vector2d tangent(Eigen::Index j, double q, double qdot, const ModeTransition& of,
                          const System& tangent) const;
  // Derivative of the flow matrix [qq qv; vq vv] of `of`, likewise with both phases kept: that of
  // the free motion from any start.
  Eigen::Matrix2d flow_tangent(Eigen::Index j, const ModeTransition& of,
                               const System& tangent) const;

 private:
  const System& system_;
  const ExactFlow<double>& flow_;
  double theta_, s_;
  // Cosine and sine of the forcing phase at both ends; zero without forcing.
  double start_cosine_ = 0.0, start_sine_ = 0.0, end_cosine_ = 0.0, end_sine_ = 0.0;
};

// The flow matrix alone.
FlowMatrix flow_matrix(const System& system, const ExactFlow<double>& flow, double s);

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
