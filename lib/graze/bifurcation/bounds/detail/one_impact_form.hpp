// The (p, 1) solutions of a linear modal system at one stop as one regular equation that can be
// bounded over a cell of a parameter.
//
// Let A be the amplitude of the forced motion along the contact row b, a the gap less the static
// deflection, P = pT, and z_j = e^{(-delta_j + i w_j) P} with w_j the damped frequency. An impulse
// along d, repeated every P, leaves just before the next one
//
//   g = sum_j b_j d_j Im[z_j/(1 - z_j)]/w_j,    H = sum_j b_j d_j Re[z_j/(1 - z_j)] - delta_j (g)_j
//
// of displacement and speed. With the approach speed v, an impulse u = (1 + r) v and the impact
// phase theta,
//
//   Re(A e^{i theta}) = a + g u,      Re(i Omega A e^{i theta}) = v + H u,
//
// and since both are parts of one number of size |A|, with D = 1 + (1 + r) H,
//
//   for constant r:  F = |A|^2 (D^2 + (1 + r)^2 Omega^2 g^2) - (a D)^2  >= 0.
//
// There are two solutions where F > 0, folds where F = 0, none where F < 0: |kappa| = |a| of
// closed_form.hpp without its denominator D, so that where kappa has a pole F is as smooth as
// elsewhere. The cost is that of N sines, whatever the number of modes makes of the flow.
//
// z/(1 - z) has poles next to the real axis where a mode of little damping repeats with the forcing
// or a part of it, and A where its frequency is the forcing's. Of an undamped mode they are on the
// axis: g sin(w_j P/2) and A (w_j^2 - Omega^2) are taken in their place where a cell holds one, and
// F is multiplied by the squares. A free mass (w_j = 0) has g and a infinite at every value: of
// both what grows as w_j^-2 is taken.
#pragma once

#include <optional>

#include "graze/assembly/detail/system_interpolant.hpp"

namespace graze {

struct OneImpactForm {
  // A, and g, H, D as above; times the factors for undamped modes.
  MeanValueForm forced_real, forced_imaginary, displaced, returned, approached;
  MeanValueForm level;  // a, times the factor of A (or what of it grows as w_j^-2)
  MeanValueForm kick;   // (1 + r) Omega, rad/s
  bool free_mass =
      false;  // displaced and level are what grows as w_j^-2, beside which D is nothing
  bool has_factors = false;  // for undamped modes
  // Undamped with r = 1: D = 0 throughout, and two solutions wherever g is not zero.
  bool free_speed = false;

  // F; of free speed g, which changes its sign where speeds grow without bound.
  MeanValueForm fold_function() const;
};

// For impacts on `stop` (index from 0) every `period` forcing periods. Requires forcing and a
// constant restitution. Nothing where a cell is too wide to bound it.
std::optional<OneImpactForm> one_impact_form(const SystemForms& system, int stop, int period);

// A unit impulse on one mode, repeated every `duration` (s): what it leaves at a part of that in
// (0, 1) after each, of displacement per d_j, s. Nothing where a cell is too wide, or the motion
// does not repeat.
std::optional<MeanValueForm> repeated_impulse(const MeanValueForm& omega,
                                              const MeanValueForm& delta,
                                              const MeanValueForm& duration, double part);

// A solution's place among the two at a value: 1 or -1, and the same along either of them as long
// as they do not meet in a fold. `theta`: impact phase, rad. `system`: at that value. 0 where it
// cannot be told.
int family_of(const SystemForms& system, int stop, int period, double theta);

}  // namespace graze
