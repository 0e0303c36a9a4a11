// Special points of a traced branch that its tangents do not show: branch points from its
// orientation, period doublings and tori from its multipliers.
//
// Test functions are the moduli of the multipliers, sorted: rho_1 >= rho_2 >= .., each continuous
// along the branch even where multipliers meet, so that the crossing rho_j = 1 between two points
// is a root of one function; no product of all multipliers is ever formed. Multipliers outside the
// circle are counted by kind (real below -1, real above 1, complex), and a step whose counts change
// by more than one crossing is halved. Crossings that a step's ends do not show, there and back,
// are met at stations within it (crossing_stations.hpp). What crossed is read off the multiplier
// itself: real and negative a period doubling, complex a torus, real and positive a fold or branch
// point (found otherwise). Two that meet at -1 and go on along the circle are a period doubling
// too.
#pragma once

#include "graze/continuation/corrector.hpp"

namespace graze {

// Adds them to branch.critical, which holds the folds, and puts all in order along the branch.
// Those found so far where `stop` asks for it.
void add_critical_points(Branch& branch, const ZeroProblem& problem, Corrector& corrector,
                         const StopSignal& stop);

}  // namespace graze
