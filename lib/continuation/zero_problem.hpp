// The equations that are continued, F(u, parameter) = 0 with F: R^n x R -> R^n, as functions to be
// asked.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "graze/base/decompositions.hpp"
#include "graze/base/vector.hpp"

namespace graze {

struct ZeroEvaluation {
  Vector residual;              // F, n
  Matrix jacobian;              // dF/du, n x n
  Vector parameter_derivative;  // dF/dparameter, n
};

struct ZeroProblem {
  // Nothing where F cannot be evaluated.
  std::function<std::optional<ZeroEvaluation>(const Vector& u, double parameter)> evaluate;
  // u and u + m wrap are one solution for every integer m: for unknowns that are angles. Empty
  // where nothing comes round.
  Vector wrap;
  // Multipliers of the solution at (u, parameter), where it stands for the periodic orbit of
  // something: largest modulus first, conjugate pairs adjacent, as eigenvalues() gives them, with
  // or without errors. Empty function: the equations have none.
  std::function<std::vector<Eigenvalue>(const Vector& u, double parameter, ErrorBounds errors)>
      multipliers;
  // Smooth functions of the solution at whose zeros a multiplier may have a pole, as one has where
  // the speed of an impact vanishes: it runs through the unit circle next to it, in a part of a step
  // that is as small as its residue. Empty: there are none.
  std::function<Vector(const Vector& u, double parameter)> poles{};
};

}  // namespace graze
