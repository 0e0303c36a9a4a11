// All (p, 2) solutions on a pair of stops: the zeros of functions of one unknown.
//
// Of the phase problem (phase_problem.hpp) at constant restitution all but the time s from the
// first impact to the second is linear. With the second 2 pi p s/P after the first and z = e^{i
// theta_1},
//
//   speeds    (1 + H D) v = Re(r z),           r = i W (Y_1, Y_2 e^{i psi}),  D = diag(1 + r_i),
//   contact   Re(C(s) z) = a,                  C = Y - G D (1 + H D)^-1 r,
//
// two real equations for the two parts of z. They determine it,
//
//   z = i n/E,     n = a_2 C_1* - a_1 C_2*,     E = Im(C_1 C_2*),
//
// and that |z| = 1 remains, |n| = E or |n| = -E. Multiplied by det (1 + H D), n and E are
// polynomials in what the modes do in between: no poles, and nothing quicker than twice the
// quickest mode. Both are sampled that often that it shows, zeros are where they change sign, and
// minima of their size are looked into where they might reach zero.
//
// Where both equations of contact are one, n and E vanish: on one stop with s, and at s = P/2, if p
// is even, as an orbit of p/2 run twice; on stops that mirror each other at s = P/2, where the one
// equation that is left has the symmetric orbits: opposite ones if p is odd, those that see the
// same of the forced motion if it is even. These zeros are divided out. On one stop the impacts may
// change names, and half of all s suffice.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/orbit/closed_form/detail/periodic_response.hpp"

namespace graze {

class TwoImpacts {
 public:
  // Near every solution on these stops, whether an orbit or not, phases of its two impacts, rad,
  // the second within p turns after the first: starts for Newton's method, to some eight digits. A
  // solution may have several. Requires that it holds on them.
  std::vector<Vector> phases(int first, int second) const;

  // Whether it holds on these stops: constant restitution, and not no loss at all.
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

// Refers to the response. Does not hold where the modes are too quick to be sampled.
TwoImpactsAnswer two_impacts(const PeriodicResponse& response);

}  // namespace graze
