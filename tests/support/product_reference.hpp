// Products of random matrices, their eigenvalues in 50-digit arithmetic, and how far computed ones
// are from these.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "graze/base/linalg/eigenvalue.hpp"
#include "graze/base/vector.hpp"
#include "graze/flow/exact/extended.hpp"
#include "support/systems.hpp"

namespace graze::support {

using ExtendedMatrix = Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic>;

Matrix random_matrix(Dice& dice, int n);
Matrix random_rotation(Dice& dice, int n);

struct ExtendedComplex {
  Extended re, im;
  Extended distance(Complex z) const;
  Extended modulus() const;
};

std::vector<ExtendedComplex> extended_eigenvalues(const ExtendedMatrix& product);
// Of the product formed with 50 digits.
std::vector<ExtendedComplex> extended_eigenvalues(const std::vector<Matrix>& factors);

// Largest relative errors over the eigenvalues, each compared with the nearest one not yet taken.
struct Comparison {
  double of_value = 0.0;  // true error over modulus
  double of_error = 0.0;  // true error over the error given
  double given = 0.0;     // error given over modulus
};
Comparison compare(const std::vector<Eigenvalue>& values, std::vector<ExtendedComplex> expected);
Comparison compare(const std::vector<Matrix>& factors);

}  // namespace graze::support
