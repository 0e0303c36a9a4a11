// Solving the shooting equations at fixed parameters: Newton's method for good guesses, Ceres'
// Levenberg-Marquardt for poor ones. The recomputed residual is the judge of both, not the solver's
// own report of convergence (just past a fold, where there is no solution, least squares reports
// success at its smallest residual).
#pragma once

#include <optional>

#include "graze/orbit/problem/detail/polish.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

struct ShootingSolution {
  Vector x;
  double residual = 0.0;  // scaled, largest entry
  int evaluations = 0;
};

// Newton's method from x. Returns nullopt when it does not reach the tolerance.
std::optional<ShootingSolution> newton(const ShootingProblem& problem, const System& system,
                                       const Vector& x);

// Levenberg-Marquardt (Ceres) from x, then Newton. Returns nullopt when the residual stays above
// the tolerance.
std::optional<ShootingSolution> seek(const ShootingProblem& problem, const System& system,
                                     const Vector& x);

}  // namespace graze
