// Largest and smallest values of linear functions of the motion, along an arc in closed form.
#pragma once

#include "graze/flow/held/detail/exact_phase.hpp"
#include "graze/system/measured_row.hpp"

namespace graze {

// Displacement and velocity of a measured row, on the coordinates that a phase leaves free.
Observable<double> displacement_of(const ConstrainedStructure<double>& structure,
                                   const MeasuredRow& seen);
Observable<double> velocity_of(const ConstrainedStructure<double>& structure,
                               const MeasuredRow& seen);

// The smallest value over the window [from, to] that is lower than `below`; minus infinity when the
// search could not be finished. Likewise the largest that is higher than `above`.
double lowest_along(const ExactPhase<double>& phase, const Observable<double>& observable,
                    double from, double to, double below);
double highest_along(const ExactPhase<double>& phase, const Observable<double>& observable,
                     double from, double to, double above);

}  // namespace graze
