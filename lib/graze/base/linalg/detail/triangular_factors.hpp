// Eigenvectors of a product of triangular matrices from its factors, and a joint bound on those
// eigenvalues that are not known, one by one, to differ from 0.
//
// T_i, i = 0..k-1, upper triangular, n x n, maps space i to space i + 1 (space k is space 0). The
// eigenvalue j of the product is prod_i t_i, t_i = T_i(j, j), and in space i it has the vectors
//
//   T_i x_i = t_i x_{i+1},     y_{i+1}^T T_i = t_i y_i^T,     x_i(j) = y_i(j) = 1:
//
// x_i has entries up to row j, y_i from row j on, hence y_i^T x_i = 1.
#pragma once

#include <vector>

#include "graze/base/linalg/eigenvalue.hpp"
#include "graze/base/vector.hpp"

namespace graze {

using TriangularFactors = std::vector<Eigen::MatrixXcd>;  // k >= 1 of them, n x n each

// |x_i| and |y_i|, row i and column j; infinite where there are no such vectors, or
// where it was asked to stop (stop_scope.hpp) before they were known.
struct VectorNorms {
  Matrix right, left;  // k x n each
};
VectorNorms vector_norms(const TriangularFactors& factors);

// Lowers the errors of eigenvalues that are not known, one by one, to differ from 0. `list` holds
// the eigenvalues of the product times 2^exponent in the order of the diagonal, with their
// individual errors. The largest of those whose error exceeds their modulus and all smaller ones
// are bounded together. They belong to the images of the projectors P_i = 1 - sum x_i y_i^T, summed
// over all others. In orthonormal bases of these spaces factor i is a matrix of norm at most
// |P_{i+1} T_i P_i|, which a perturbation E_i of T_i changes by at most |P_{i+1}| |E_i|, to first
// order. The product of these norms, with |E_i| = `roundings` eps |T_i| (Frobenius), bounds their
// perturbed moduli. Where many eigenvalues crowd about 0, as those of strongly damped fast modes,
// the projectors are well determined and the individual vectors are not.
void bound_together(const TriangularFactors& factors, double roundings, long exponent,
                    std::vector<Eigenvalue>& list);

}  // namespace graze
