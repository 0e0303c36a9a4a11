// All (p, 2) solutions on a pair of stops: the zeros of functions of one unknown.
//
// In the phase problem (phase_problem.hpp) at constant restitution, everything is linear except the
// time s from the first impact to the second. With the second 2 pi p s/P after the first and z =
// e^{i theta_1},
//
//   speeds    (1 + H D) v = Re(r z),           r = i W (Y_1, Y_2 e^{i psi}),  D = diag(1 + r_i),
//   contact   Re(C(s) z) = a,                  C = Y - G D (1 + H D)^-1 r,
//
// two real equations for the two parts of z. They determine it,
//
//   z = i n/E,     n = a_2 C_1* - a_1 C_2*,     E = Im(C_1 C_2*),
//
// and the condition |z| = 1 is left, |n| = E or |n| = -E. Multiplied by det (1 + H D), n and E are
// polynomials in the modal motions between the impacts: they have no poles, and no frequency above
// twice the highest modal one. Both are sampled often enough for that, zeros are where they change
// sign, and minima of their size are examined where they might reach zero.
//
// Where both contact equations are one, n and E vanish: on one stop with s, and at s = P/2, if p is
// even, as an orbit of p/2 run twice; on stops that mirror each other at s = P/2, where the one
// contact equation left has the symmetric orbits: for odd p with opposite impacts, for even p with
// impacts at the same phase of the forced motion. These zeros are divided out. On one stop the
// impacts may be exchanged, and half of all s suffice.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/orbit/closed_form/detail/periodic_response.hpp"

namespace graze {

class TwoImpacts {
 public:
  // Approximations of every solution on these stops, whether an orbit or not, as phases of its two
  // impacts, rad, the second within p forcing periods after the first: starts for Newton's method,
  // to some eight digits. A solution may appear several times. Requires holds(first, second).
  std::vector<Vector> phases(int first, int second) const;

  // Whether the method applies to these stops: constant restitution, and some loss of energy.
  bool holds(int first, int second) const;

 private:
  friend struct TwoImpactsAnswer two_impacts(const PeriodicResponse& response);
  explicit TwoImpacts(const PeriodicResponse& response, int intervals);
  class Pair;

  const PeriodicResponse* response_;
  int intervals_;  // of all s, an even number
  // Displacements and velocities of the modes at the ends of the intervals after unit impulses.
  Matrix displacements_, velocities_;
  std::vector<RowMotion> own_;  // of each stop: an impact's own impulse, one orbit later
  std::vector<bool> regular_;   // by stop: whether its speed follows from the rates
};

struct TwoImpactsAnswer {
  std::optional<TwoImpacts> form;
  std::string why_not;  // a sentence where there is none
};

// Refers to the response. Absent where the modes are too fast to be sampled.
TwoImpactsAnswer two_impacts(const PeriodicResponse& response);

}  // namespace graze
