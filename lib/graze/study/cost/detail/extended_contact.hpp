// A contact with a compliant stop in 50 digits, as a reference for flows in double precision.
//
// The equations are those of system.hpp, the force that of contact_force.hpp, both implemented
// again for that scalar. They are integrated by extrapolation of the modified midpoint rule (W. B.
// Gragg, SIAM J. Numer. Anal. 2 (1965) 384-403), up to order 28, steps halved until two
// extrapolations agree to kReferenceTolerance. x^n has no Taylor series at x = 0 for a non-integer
// n: steps begin with kFirstStep of the contact, where that part of the force is negligible, and
// shorten towards its end in proportion to the remaining time, down to kLastStep.
#pragma once

#include <string>

#include "graze/base/stop_signal.hpp"
#include "graze/flow/exact/detail/exact_flow.hpp"
#include "graze/flow/exact/extended.hpp"
#include "graze/system/system.hpp"

namespace graze {

// Tolerance of a step within a contact, relative to the displacements and to the velocities. The
// error of a whole contact is some thousand times that, far below the rounding of double precision.
inline constexpr double kReferenceTolerance = 1e-24;

struct ExtendedContact {
  RealVector<Extended> q, qdot;  // where the structure leaves the stop
  Extended separation = 0;       // s after the beginning: the force is gone
  Extended end = 0;              // s after the beginning: the stop is left; later where the force
                                 // was gone below its surface
  std::string message;           // why it could not be followed to its end; else empty
};

struct ExtendedContactOptions {
  Extended theta = 0;    // forcing phase at the beginning, rad
  double longest = 0.0;  // s, no contact is followed longer
  StopSignal stop{};
};

// Starts at q, qdot on the surface of the compliant `stop`, approaching it, with no other stop in
// contact; when another one is reached, at the end of a step, the message says so.
ExtendedContact follow_contact(const System& system, int stop, RealVector<Extended> q,
                               RealVector<Extended> qdot, const ExtendedContactOptions& options);

}  // namespace graze
