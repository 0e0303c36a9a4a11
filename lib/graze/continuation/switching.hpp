// Continuing across special points.
//
//   #include "graze/continuation/switching.hpp"
//
// At a branch point the kernel of dF/dx is two-dimensional. The tangents a t1 + b t2 of the
// branches through it solve the algebraic bifurcation equation
//
//   psi^T F_xx [a t1 + b t2]^2 = 0,   psi the left null vector;
//
// one root is the known branch, the other the branch that crosses it (Keller, in: Applications of
// Bifurcation Theory, 1977; Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria,
// 2000). A period doubling is a branch point of the equations of twice the period.
#pragma once

#include <optional>

#include "graze/continuation/branch.hpp"

namespace graze {

// The branch point once more, with the tangent of the other branch through it: a start for
// trace_branch. `at.tangent` is that of the known one. Returns nullopt when the equations cannot be
// evaluated around it, or no second branch can be distinguished.
std::optional<SolutionPoint> other_branch(const ZeroProblem& problem,
                                          const ContinuationOptions& options,
                                          const SolutionPoint& at);

// A branch that was traced both ways from a branch point has that among its points, a closed one at
// its ends: lists it among the special points.
void list_crossing(Branch& branch);

}  // namespace graze
