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
// closed_form.hpp without its denominator D, so that F is smooth even where kappa has a pole. The
// cost is that of N sines.
//
// z/(1 - z) has poles next to the real axis where the free motion of a slightly damped mode has the
// period of the forcing or a fraction of it, and A where its frequency is the forcing's. For an
// undamped mode they are on the axis: g sin(w_j P/2) and A (w_j^2 - Omega^2) replace g and A where
// a cell holds a pole, and F is multiplied by the squares. A free mass (w_j = 0) has infinite g and
// a at every value: both are then replaced by their coefficients of w_j^-2.
#pragma once

#include <optional>

#include "graze/assembly/detail/system_interpolant.hpp"

namespace graze {

struct OneImpactForm {
  // A, and g, H, D as above; times the factors for undamped modes.
  MeanValueForm forced_real, forced_imaginary, displaced, returned, approached;
  MeanValueForm level;  // a, times the factor of A (or its coefficient of w_j^-2)
  MeanValueForm kick;   // (1 + r) Omega, rad/s
  bool free_mass =
      false;  // displaced and level are coefficients of w_j^-2, beside which D is nothing
  bool has_factors = false;  // for undamped modes
  // Undamped with r = 1: D = 0 throughout, and two solutions wherever g is not zero.
  bool free_speed = false;

  // F; with free speed g, which changes its sign where speeds grow without bound.
  MeanValueForm fold_function() const;
};

// For impacts on `stop` (index from 0) every `period` forcing periods. Requires forcing and a
// constant restitution. Returns nullopt when a cell is too wide for bounds.
std::optional<OneImpactForm> one_impact_form(const SystemForms& system, int stop, int period);

// The response of one mode to a unit impulse on it, repeated every `duration` (s): its displacement
// per d_j, s, at a part of the duration in (0, 1) after each impulse. Returns nullopt when a cell
// is too wide, or the motion does not repeat.
std::optional<MeanValueForm> repeated_impulse(const MeanValueForm& omega,
                                              const MeanValueForm& delta,
                                              const MeanValueForm& duration, double part);

// Which of the two solutions at a value this is: 1 or -1, constant along each of them as long as
// they do not meet in a fold. `theta`: impact phase, rad. `system`: at that value. 0 where it
// cannot be decided.
int family_of(const SystemForms& system, int stop, int period, double theta);

}  // namespace graze
