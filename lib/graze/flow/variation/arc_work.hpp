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

#include "graze/flow/variation/work.hpp"
#include "graze/system/system.hpp"

namespace graze {

template <class Real>
class ContactPhase;

// Work from the start of the phase's arc over s seconds. `theta`: forcing phase there, rad, which
// counts where stops move.
Work work_along(const System& system, const ContactPhase<double>& phase, double s,
                double theta = 0.0);

}  // namespace graze
