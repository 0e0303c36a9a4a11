// Second derivatives of the shooting equations, contracted with a vector from the left and one from
// the right, as the equations of a locus in two parameters need them (zero_problem.hpp). Analytic.
#pragma once

#include <span>

#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

// Gradient of w^T (jacobian + (mu - 1) closing) v at fixed w, v and mu (see ShootingLinearisation),
// by the unknowns x, k (2N + 1) entries, and after them by the parameters that move the system
// along the tangents. Nothing is conjugated.
Vector shooting_curvature(const ShootingProblem& problem, const System& system, const Vector& x,
                          std::span<const System* const> tangents, const Vector& w, const Vector& v,
                          double mu);
ComplexVector shooting_curvature(const ShootingProblem& problem, const System& system,
                                 const Vector& x, std::span<const System* const> tangents,
                                 const ComplexVector& w, const ComplexVector& v, Complex mu);

}  // namespace graze
