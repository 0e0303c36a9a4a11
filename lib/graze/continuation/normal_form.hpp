// The normal forms of folds and doublings of a map's orbits, on their centre manifold:
//
//   LP   x -> x + beta + a x^2 + ..          PD   x -> -(1 + ..) x + b x^3 + ..
//
// with x along the critical eigenvector q, |q| = 1 in the unknowns of one period, and the left one
// p so that p.q = 1 in the sense of the map, -p.closing q = 1 (Y. A. Kuznetsov, Elements of Applied
// Bifurcation Theory, 3rd ed., 5.4). They are taken from solutions beside the point, x away from
// it: by the branch itself at a fold, by the doubled one at a doubling. No higher derivative is
// needed, so that any equations will do.
#pragma once

#include <optional>

#include "graze/continuation/branch.hpp"

namespace graze {

struct NormalForm {
  double coefficient = 0.0;  // a or b; of a doubling b > 0: supercritical
  // The solutions beside it lie at the parameter p + opening x^2, those of the branch at a fold and
  // the doubled ones at a doubling.
  double opening = 0.0;
  double error = 0.0;  // of the opening: the change by the last refinement
};

// `fold`: a critical point of that kind. Returns nullopt where solutions beside it cannot be found.
std::optional<NormalForm> fold_form(const ZeroProblem& problem, const ContinuationOptions& options,
                                    const SolutionPoint& fold);

// `doubled`: the equations of twice the period; `twice`: the doubling as one of their solutions
// (twice_round). Returns nullopt likewise.
std::optional<NormalForm> doubling_form(const ZeroProblem& problem,
                                        const ContinuationOptions& options,
                                        const SolutionPoint& doubling, const ZeroProblem& doubled,
                                        const SolutionPoint& twice);

}  // namespace graze
