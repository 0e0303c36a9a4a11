// Lanczos' iteration on (K - s M)^-1 M (Spectra).
#pragma once

#include <optional>

#include "graze/fem/detail/sparse_cholesky.hpp"

namespace graze {

// The mass may be singular, of the rank `rank`: the iteration stays in the range of (K - s M)^-1 M,
// where the mass is definite (Nour-Omid, Parlett, Ericsson & Jensen, Math. Comp. 48 (1987) 663).
// Parts that rounding adds outside that range are removed by one more product by (K - s M)^-1 M.

// The vectors of the `count` eigenvalues nearest above the shift of `factors`, lowest first;
// nullopt when the iteration does not converge. `attempt`: a further one starts elsewhere and keeps
// a larger space.
std::optional<Matrix> shift_invert_vectors(const SparseCholesky& factors, const SparseMatrix& mass,
                                           int rank, int count, double shift, int attempt);

// The eigenvalue nearest above the shift among those of vectors orthogonal in M to `found`, whose
// columns are orthonormal in M; nullopt when the iteration does not converge.
std::optional<double> nearest_other(const SparseCholesky& factors, const SparseMatrix& mass,
                                    int rank, const Matrix& found, double shift);

// The smallest eigenvalue of D^-1/2 M D^-1/2, D the diagonal of M, to about 1e-3 of the largest;
// nullopt when the iteration does not converge.
std::optional<double> smallest_scaled_mass(const SparseMatrix& mass);

}  // namespace graze
