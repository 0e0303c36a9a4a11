// Work done along an arc, for the energy balance:
//
//   change of (|q'|^2 + |w q|^2)/2 = forcing + load + constraint + contact + stops - dissipation.
//
// Velocities and forces of a mode are sums Re(c e^{l s}); the integrals of their products are known
// in closed form. Where that form would cancel (near critical damping, near resonance, over a
// flight short against the mode) Gauss' rule is used, on panels short enough for it to be exact to
// rounding; there are at most some hundred of them, whatever the rates of the mode. Modes that a
// closed stop couples are integrated by doubling the integral over a short flight. On compressed
// springs the works are integrated with the motion.
#pragma once

#include "graze/system/system.hpp"

namespace graze {

template <class Real>
class ContactPhase;

struct Work {
  double forcing = 0.0;      // of the harmonic forcing, J
  double load = 0.0;         // of the constant load, J
  double constraint = 0.0;   // of the closed stops; zero except with an oblique law, J
  double dissipation = 0.0;  // taken by damping, J, >= 0
  double contact = 0.0;      // of compliant stops, J: minus the energy that they took, kept or lost
  // The part of that energy which their damping took, J, >= 0: it may exceed all energy of the
  // structure, if springs were compressed at the start.
  double contact_lost = 0.0;
  double stops = 0.0;  // of stops that move, J; works are then those on the structure itself
};

// Work from the start of the phase's arc over s seconds. `theta`: forcing phase there, rad, which
// counts where stops move.
Work work_along(const System& system, const ContactPhase<double>& phase, double s,
                double theta = 0.0);

}  // namespace graze
