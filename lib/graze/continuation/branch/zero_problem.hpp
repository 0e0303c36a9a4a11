// The equations that are continued, F(u, parameters) = 0 with F: R^n x R^m -> R^n, as callable
// functions: over one parameter for a branch (branch.hpp), over two for a locus (locus.hpp).
//
// Where solutions stand for periodic orbits of something, their multipliers are the numbers mu at
// which
//
//   A(mu) = dF/du + (mu - 1) closing
//
// is singular: the deviation that closes the orbit is counted mu times. The orbit itself closes
// with mu = 1, so dF/du = A(1).
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/base/vector.hpp"

namespace graze {

// Values of the parameters, in their order, m.
using Parameters = std::span<const double>;

struct ZeroEvaluation {
  Vector residual;       // F, n
  Matrix jacobian;       // dF/du, n x n
  Matrix by_parameters;  // dF/dparameters, n x m
  Matrix closing{};      // n x n; only loci ask for it
};

// A product left^T A(multiplier) right, without conjugation.
struct CriticalProduct {
  ComplexVector left, right;  // n
  Complex multiplier;
};

struct ZeroProblem {
  // Returns nullopt when F cannot be evaluated.
  std::function<std::optional<ZeroEvaluation>(const Vector& u, Parameters at)> evaluate;
  // u and u + m wrap are the same solution for every integer m: for unknowns that are angles. Empty
  // where no unknown is periodic.
  Vector wrap;
  // Multipliers of the solution, where it stands for a periodic orbit: largest modulus first,
  // conjugate pairs adjacent, as eigenvalues() gives them, with or without errors. Empty function:
  // the equations have none, or their special points are not searched for.
  std::function<std::vector<Eigenvalue>(const Vector& u, Parameters at, ErrorBounds errors)>
      multipliers;
  // Smooth functions of the solution at whose zeros a multiplier may have a pole, as it has where
  // the speed of an impact vanishes: near a pole it passes the unit circle within a part of a step
  // that is as small as its residue. Empty: there are none.
  std::function<Vector(const Vector& u, Parameters at)> poles{};
  // The derivatives of each product by (u, parameters) with its vectors and multiplier held fixed,
  // as a row of a matrix of n + m columns. All are computed together because the second derivatives
  // of F, which are most of the work, are the same for all. Returns nullopt when F cannot be
  // evaluated. Only loci call it.
  std::function<std::optional<Eigen::MatrixXcd>(const Vector& u, Parameters at,
                                                const std::vector<CriticalProduct>& products)>
      curvature{};
};

}  // namespace graze
