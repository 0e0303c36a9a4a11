// The (p, 1) orbits of a linear modal system with one constant-restitution stop, in closed form.
//
// With E the flow over p periods, J the jump, c the contact row and Re(R e^{i phi}) the forced
// response from rest over p periods that start at impact phase phi, the state before the impact is
//
//   y- = (I - E J)^-1 Re(R e^{i phi}),   contact:  |kappa| cos(phi + arg kappa) = gap,
//
// A constant load adds its own (I - E J)^-1 r_0 to y-, r_0 its response from rest, and so moves the
// gap. (R = (I - E) Y where there is a steady response Y; R exists at resonance too.) There are
// two solutions where |kappa| > |gap|, a fold exactly where they meet.
//
// For an undamped structure with r = 1, I - E J is singular: the motion can repeat at some phases
// only, and then with any speed. kappa is infinite. Contact is then solved first: with an impulse
// smaller by g than that of the law,
//
//   (I - E J) y- + E (0; d) g = Re(R e^{i phi}) + r_0,      b.q- = gap,
//
// is regular, and g = Re(gamma e^{i phi}) + g_0 + g_1 gap = 0 gives the phases.
//
// It gives starts to the finder and checks shooting, continuation, multipliers and simulation.
// Admissibility is not considered.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/orbit/problem/impact_pattern.hpp"

namespace graze {

struct ClosedForm {
  // kappa| cos(phi + arg kappa) = by_gap gap - moved. Lengths, m, with by_gap 1; where I - E J is
  // singular they are -gamma, -g_0 and g_1, in units of W times a length.
  Complex kappa;
  double by_gap = 1.0, moved = 0.0;
  ComplexVector response;  // y- = Re(response e^{i phi}) + rest + per_gap gap, (q; q'), 2N
  State rest;              // part of y- that a constant load makes
  State per_gap;           // zero where by_gap is 1

  // The solutions for contact at `gap`: none, or two (equal at the fold), phase in [0, 2 pi).
  std::vector<ImpactPoint> solutions(double gap) const;
};

struct ClosedFormAnswer {
  std::optional<ClosedForm> form;
  std::string why_not;  // a sentence where the closed form does not hold
};

// Closed form for impacts on `stop` every `period` forcing periods. Absent without forcing, or
// where neither order of solving the equations is regular.
ClosedFormAnswer closed_form(const System& system, int stop, int period);

}  // namespace graze
