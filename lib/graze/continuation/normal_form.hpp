// The normal forms of folds, doublings and tori of a map's orbits, on their centre manifold:
//
//   LP   x -> x + beta + a x^2 + ..          PD   x -> -(1 + ..) x + b x^3 + ..
//   NS   z -> mu z ((1 + ..) + d |z|^2 + ..), a = Re d
//
// with x along the critical eigenvector q, |q| = 1 in the unknowns of one period, and z q + its
// conjugate; the left one p so that p.q = 1 in the sense of the map, -p.closing q = 1 (Y. A.
// Kuznetsov, Elements of Applied Bifurcation Theory, 3rd ed., 5.4). That of LP is taken from
// solutions beside the point, x away from it; those of PD and NS from derivatives of the equations
// of two periods, second and third ones by differences of the first, in orders so high that the
// digits lost are those of rounding. Where these equations do not hold both periods' unknowns, that
// of PD is taken from doubled solutions beside the point, and that of NS is not known.
#pragma once

#include <optional>

#include "graze/continuation/branch.hpp"

namespace graze {

struct NormalForm {
  double coefficient = 0.0;  // supercritical are PD with b > 0 and NS with a < 0
  // What is beside it lies at the parameter p + opening x^2: the solutions of the branch at a fold,
  // the doubled ones at a doubling, the torus of |z| = x.
  double opening = 0.0;
  double error = 0.0;  // of the opening at LP, else of a or b: by how much three distances differ
};

// `fold`: a critical point of that kind. Returns nullopt where solutions beside it cannot be found.
std::optional<NormalForm> fold_form(const ZeroProblem& problem, const ContinuationOptions& options,
                                    const SolutionPoint& fold);

// `doubled`: the equations of twice the period; `twice`: the doubling as one of their solutions
// (twice_round). Returns nullopt where no three distances agree.
std::optional<NormalForm> doubling_form(const ZeroProblem& problem,
                                        const ContinuationOptions& options,
                                        const SolutionPoint& doubling, const ZeroProblem& doubled,
                                        const SolutionPoint& twice);

// `multiplier`: the critical one, either of the pair. `doubled` and `twice`: as above, its unknowns
// those of the first period and of the second. Returns nullopt where they are not, and likewise.
std::optional<NormalForm> torus_form(const ZeroProblem& problem, const ContinuationOptions& options,
                                     const SolutionPoint& torus, Complex multiplier,
                                     const ZeroProblem& doubled, const SolutionPoint& twice);

// a of NS, and -3 b of PD (whose multiplier is -1), at any point of their loci. `twice`: the
// unknowns of both periods. Returns nullopt likewise.
std::optional<double> cubic_coefficient(const ZeroProblem& doubled, const Vector& twice,
                                        Parameters at, Complex multiplier);

}  // namespace graze
