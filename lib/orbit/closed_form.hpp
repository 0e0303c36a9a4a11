// The (p, 1) orbits of a linear modal system with one constant-restitution stop, in closed form.
//
// With E the flow over p periods, J the jump, c the contact row and Re(R e^{i phi}) the forced
// response from rest over p periods that start at impact phase phi, the state before the impact is
//
//   y- = (I - E J)^-1 Re(R e^{i phi}),   contact:  |kappa| cos(phi + arg kappa) = gap,
//
// A constant load adds its own (I - E J)^-1 r_0 to y-, r_0 its response from rest, and so moves the
// gap. (R = (I - E) Y where there is a steady response Y; R exists at resonance too.) There are
// two solutions where |kappa| > |gap|, a fold exactly where they meet. It starts the finder and
// referees shooting, continuation, multipliers and simulation; it knows nothing of admissibility.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/orbit/shooting.hpp"

namespace graze {

struct ClosedForm {
  Complex kappa;           // m
  State rest;              // part of y- that a constant load makes
  double moved = 0.0;      // row.rest, m
  ComplexVector response;  // y- = Re(response e^{i phi}), (q; q'), 2N

  // The solutions for contact at `gap`: none, or two (equal at the fold), phase in [0, 2 pi).
  std::vector<ImpactPoint> solutions(double gap) const;
};

struct ClosedFormAnswer {
  std::optional<ClosedForm> form;
  std::string why_not;  // a sentence where the closed form does not hold
};

// Closed form for impacts on `stop` every `period` forcing periods. Does not hold without forcing,
// or where I - E J is singular.
ClosedFormAnswer closed_form(const System& system, int stop, int period);

}  // namespace graze
