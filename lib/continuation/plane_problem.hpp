// Equations with two parameters, F(u, p, q) = 0 with F: R^n x R x R -> R^n, whose solutions stand
// for periodic orbits of something: what a locus of folds, period doublings or tori is sought for
// (locus.hpp).
//
// The orbit's multipliers are the numbers mu at which
//
//   A(mu) = jacobian + mu closing
//
// is singular: what the orbit comes round to is counted mu times. The orbit itself closes with mu =
// 1, so dF/du = A(1).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "graze/base/decompositions.hpp"
#include "graze/base/vector.hpp"

namespace graze {

struct PlaneEvaluation {
  Vector residual;             // F, n
  Matrix jacobian;             // dF/du without `closing`, n x n
  Matrix closing;              // n x n
  Vector by_first, by_second;  // dF/dp, dF/dq, n
};

// A product left^T A(multiplier) right, without conjugation.
struct PlaneProduct {
  ComplexVector left, right;  // n
  Complex multiplier;
};

struct PlaneProblem {
  // Nothing where F cannot be evaluated.
  std::function<std::optional<PlaneEvaluation>(const Vector& u, double p, double q)> evaluate;
  // The derivatives of each product by (u, p, q) with its vectors and multiplier held fixed, as a
  // row of a matrix of n + 2 columns. All are asked for at once because the second derivatives of
  // F, which are most of the work, are the same for all. Nothing as above.
  std::function<std::optional<Eigen::MatrixXcd>(const Vector& u, double p, double q,
                                                const std::vector<PlaneProduct>& products)>
      curvature;
  Vector wrap;  // as in ZeroProblem
  // All multipliers, as in ZeroProblem. Empty function: special points of a locus that further
  // multipliers make are not looked for.
  std::function<std::vector<Eigenvalue>(const Vector& u, double p, double q, ErrorBounds errors)>
      multipliers;
};

}  // namespace graze
