// Branch points as regular solutions of a larger system.
//
// At a branch point dF/dx (n x (n + 1)) has rank n - 1, and next to it the branch itself is badly
// determined along the one that crosses. With borders b (n) and C (2 x (n + 1)) that span what is
// missing,
//
//   [dF/dx, b; C, 0] [V; g] = [0; I],      F + m b = 0,   g(x) = 0
//
// has the branch point as a regular solution (x, m), m = 0, known to the rounding of F and dF/dx.
//
// Griewank and Reddien, SIAM J. Numer. Anal. 21 (1984) 176-185; Govaerts, Numerical Methods for
// Bifurcations of Dynamical Equilibria, 2000.
#pragma once

#include <optional>

#include "graze/continuation/branch/detail/corrector.hpp"

namespace graze {

// The branch point near a guess, as x = (u, parameter/range). Nothing where Newton's method does
// not converge.
std::optional<Vector> crossing_near(Corrector& corrector, const Vector& guess);

}  // namespace graze
