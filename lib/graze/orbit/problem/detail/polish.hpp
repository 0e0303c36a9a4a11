// Newton's method on the equations of an orbit of any kind: the last step of each search, after
// rough guesses have been brought near. The recomputed residual is the judge.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/base/vector.hpp"

namespace graze {

// Largest scaled residual of a solution. Residuals of unit-scaled equations carry some tens of
// roundings (1e-14); the smallest residual where there is no solution is the distance to the fold.
inline constexpr double kShootingTolerance = 1e-11;

// Largest Newton step that is left at a solution, relative to its size: how well it is determined,
// at worst, beside a fold.
inline constexpr double kShootingAccuracy = 1e-7;

template <class Equations>
struct Polished {
  Vector u;
  Equations at;           // there
  double residual = 0.0;  // scaled, largest entry
  int evaluations = 0;    // of all that it took
};

// Newton's method from u on. `equations_at` returns an optional struct with the `residual` and the
// `jacobian` of the equations. Returns nullopt when they cannot be evaluated, or when the tolerance
// is not reached.
template <class Evaluate>
auto polish(Vector u, const Evaluate& equations_at) {
  using Equations = typename std::invoke_result_t<const Evaluate&, const Vector&>::value_type;
  constexpr int kMostSteps = 12;
  // Stops when the residual has not shrunk within some steps.
  constexpr int kPatience = 4;
  std::optional<Polished<Equations>> best;
  double least = std::numeric_limits<double>::infinity();
  int evaluations = 0, since = 0;
  for (int step = 0; step <= kMostSteps; ++step) {
    std::optional<Equations> at = equations_at(u);
    ++evaluations;
    if (!at || !at->residual.allFinite()) break;
    const double residual = at->residual.size() > 0 ? at->residual.cwiseAbs().maxCoeff() : 0.0;
    // Below the tolerance goes on while the residual halves: the last digits cost one more step.
    if (best && !(residual < 0.5 * best->residual)) break;
    since = residual < 0.5 * least ? 0 : since + 1;
    if (since > kPatience) break;
    least = std::fmin(least, residual);
    const Vector update =
        u.size() > 0 ? LuFactors(at->jacobian).solve(at->residual) : Vector(Vector::Zero(0));
    if (!update.allFinite()) break;
    // Between two solutions that nearly meet the residual is small too, but not Newton's step.
    if (residual <= kShootingTolerance && update.norm() <= kShootingAccuracy * (1.0 + u.norm()))
      best = Polished<Equations>{u, std::move(*at), residual, 0};
    if (update.isZero(0.0)) break;
    u -= update;
  }
  if (best) best->evaluations = evaluations;
  return best;
}

}  // namespace graze
