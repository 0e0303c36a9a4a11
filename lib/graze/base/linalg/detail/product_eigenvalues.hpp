// Eigenvalues of a product of square matrices, from the factors.
//
// The product M = A_k .. A_1, once formed, has a rounding error of eps |M| in every entry, which
// hides all smaller eigenvalues, and leaves four digits of multiplier 1 beside one of 1e12. From
// the periodic Schur form (periodic_schur.hpp) every eigenvalue only suffers from the rounding of
// each factor relative to itself.
//
// Error. Let T_i, i = 1..k, be the triangular factors. For the eigenvalue l = prod_i t_i with
// t_i = T_i(j, j) let
//
//   T_i x_{i-1} = t_i x_i,     y_i^* T_i = t_i y_{i-1}^*,     x_i(j) = y_i(j) = 1   (x_k = x_0):
//
// x_i has entries up to row j, y_i from row j on, hence y_i^* x_i = 1. To first order,
// perturbations E_i of the factors move l by sum_i (prod_{m != i} t_m) y_i^* E_i x_{i-1}; with
// |E_i| = eps n |A_i| (Frobenius), the rounding of a factor and of the reflections it goes through,
//
//   error = eps n sum_i |prod_{m != i} t_m| |A_i| |y_i| |x_{i-1}|.
//
// It holds where the factors are known to their rounding relative to their norms; where they are
// not, n is raised by `uncertainty`. Eigenvalues that are not known to differ from 0 are bounded
// together (triangular_factors.hpp) where that bound is smaller. Where both exceed Elsner's bound
// of the product (decompositions.hpp), as they do for defective products, Elsner's is used: (|M| +
// e)^(1 - 1/n) e^(1/n), e the first-order bound on the change of M.
//
// Elsner, Linear Algebra Appl. 71 (1985) 77-80; Benner, Mehrmann and Xu, ETNA 11 (2000) 1-12 (the
// perturbation of formal products).
#pragma once

#include <vector>

#include "graze/base/linalg/decompositions.hpp"

namespace graze {

// Eigenvalues of factors.back() .. factors.front(), n x n each, in the order of eigenvalues(). A
// factor is deficient in rank when its rows and columns are dependent within n eps of their sizes;
// the eigenvalues that this makes zero are exactly zero. Empty when there are no factors, when the
// iteration does not converge or was asked to stop (stop_scope.hpp), and when an entry is not
// finite. For one factor this is eigenvalues(), whose zeros are within their error only. Products
// of diagonal entries neither overflow nor vanish where their value is representable. The values do
// not depend on whether their errors are computed.
std::vector<Eigenvalue> product_eigenvalues(const std::vector<Matrix>& factors,
                                            ErrorBounds errors = ErrorBounds::kGiven,
                                            double uncertainty = 0.0);

}  // namespace graze
