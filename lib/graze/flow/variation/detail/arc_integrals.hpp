// Integrals along an arc of what is linear in its motion.
#pragma once

#include "graze/flow/held/detail/exact_phase.hpp"

namespace graze {

// Of c: integrals of c, of c^2, and of c e^{-i theta} over the forcing phase theta; s, in the unit
// of c.
struct ArcIntegrals {
  double value = 0.0, square = 0.0;
  Complex turned = 0.0;
};

// From the start of the phase's arc over s seconds; of an observable of its coordinates y and y'.
// In closed form where the motion is a sum of exponentials, or by moments where closed stops couple
// its modes; else by panels.
ArcIntegrals integrals_along(const ExactPhase<double>& phase, const Observable<double>& observable,
                             double s);
// That of c^2 alone.
double square_along(const ExactPhase<double>& phase, const Observable<double>& observable,
                    double s);

}  // namespace graze
