// Eigenvalues of a product of jumps of low rank and flows in blocks (secular_function.hpp), without
// forming it.
//
// All roots of det(mu - M) at once by the iteration of Ehrlich and Aberth,
//
//   z_i <- z_i - N/(1 - N sum_j 1/(z_i - z_j)),   N = p/p' at z_i,
//
// p'/p from the secular equation: a few dozen operations a mode, so that all eigenvalues cost
// O(n^2). Each starts at those of its mode's own block of M; a root is left alone once its next
// step is below its rounding. Modes that no jump couples to the others keep the eigenvalues of
// their flow, and so do, to the 100th decimal, those that the flow extinguishes.
//
// All eigenvalues are found when their sum is the trace of M and their product its determinant.
//
// Ehrlich, Comm. ACM 10 (1967) 107-108; Aberth, Math. Comp. 27 (1973) 339-344; for the eigenvalues
// of structured matrices Bini, Gemignani and Tisseur, SIAM J. Matrix Anal. Appl. 27 (2005) 153-175.
#pragma once

#include <optional>
#include <vector>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/base/linalg/detail/secular_function.hpp"

namespace graze {

// Returns the eigenvalues in the order of eigenvalues(), the same with and without their errors.
// These are of first order, for every jump changed by 2n eps of its norm and every block of a flow
// by its uncertainty. Returns nullopt when an eigenvalue is not found within some dozens of steps,
// when sum or product show that one is missing, or when a factor is singular or not finite.
std::optional<std::vector<Eigenvalue>> secular_eigenvalues(const std::vector<JumpAndFlow>& factors,
                                                           ErrorBounds errors);

}  // namespace graze
