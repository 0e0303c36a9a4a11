// The matrix decompositions that are slow to compile, kept in one translation unit.
#pragma once

#include <vector>

#include "graze/base/linalg/eigenvalue.hpp"
#include "graze/base/vector.hpp"

namespace graze {

// Ratio of the largest to the smallest singular value; infinity for a singular matrix.
double condition_number(const Matrix& matrix);

// Sorts by falling modulus, of a conjugate pair the negative imaginary part first.
void sort_eigenvalues(std::vector<Eigenvalue>& list);

// Whether errors are computed. They cost about as much as the eigenvalues; left out they are 0.
enum class ErrorBounds { kGiven, kLeftOut };

// Eigenvalues of a real square matrix, largest modulus first, conjugate pairs adjacent with the
// negative imaginary part first; the same to the last bit with and without their errors. Empty when
// the iteration does not converge. `uncertainty`, in eps |A|: how far the matrix may be from the
// intended one, in addition to the n of the decomposition. When it was asked to stop
// (stop_scope.hpp), bounds that are not yet computed are replaced by Elsner's.
std::vector<Eigenvalue> eigenvalues(const Matrix& matrix, ErrorBounds errors = ErrorBounds::kGiven,
                                    double uncertainty = 0.0);

// A = V diag(values) V^-1.
struct ComplexModes {
  ComplexVector values;
  Eigen::MatrixXcd vectors, inverse;  // V, V^-1
  double condition = 0.0;             // |V| |V^-1| (Frobenius), at least n; infinite when defective
  double error = 0.0;                 // of the values, of the matrix's unit
};
ComplexModes complex_modes(const Matrix& matrix);

// Eigenvalues of a symmetric matrix, smallest first, and orthonormal vectors in their order. Values
// are right to the unit roundoff of the largest. Only the lower triangle is read.
struct SymmetricModes {
  Vector values;
  Matrix vectors;
};
SymmetricModes symmetric_modes(const Matrix& matrix);

// The largest growth rate of x' = A x measured in the Euclidean norm: the largest eigenvalue of
// (A + A^T)/2; |x(t)| <= e^{rate t} |x(0)|.
double norm_growth_rate(const Matrix& matrix);

// The matrix exponential (Pade approximation with scaling and squaring).
Matrix matrix_exponential(const Matrix& matrix);

// A unit vector that `matrix` (n x (n + 1)) maps to zero.
Vector null_vector(const Matrix& matrix);

// Orthonormal bases of what a matrix (n x (n + 1)) nearly maps to zero, from either side: the
// `dimension` right and `dimension` - 1 left singular vectors of its smallest singular values.
struct NullSpaces {
  Matrix right;  // (n + 1) x dimension
  Matrix left;   // n x (dimension - 1)
};
NullSpaces null_spaces(const Matrix& matrix, int dimension);

}  // namespace graze
