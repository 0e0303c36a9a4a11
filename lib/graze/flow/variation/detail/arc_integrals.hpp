// Integrals along an arc of linear functions of its motion.
#pragma once

#include "graze/flow/held/detail/exact_phase.hpp"

namespace graze {

// For an observable c: integrals of c, of c^2, and of c e^{-i theta} with the forcing phase theta;
// in s and the unit of c.
struct ArcIntegrals {
  double value = 0.0, square = 0.0;
  Complex turned = 0.0;
};

// Integrals from the start of the phase's arc over s seconds, for an observable of its coordinates
// y and y'. In closed form where the motion is a sum of exponentials, or by moments where closed
// stops couple its modes; else by panels.
ArcIntegrals integrals_along(const ExactPhase<double>& phase, const Observable<double>& observable,
                             double s);
// The integral of c^2 alone.
double square_along(const ExactPhase<double>& phase, const Observable<double>& observable,
                    double s);

}  // namespace graze
