// Fixed points of an iterated map x -> f(x, parameter) as a zero problem for continuation.
//
//   #include "graze/continuation/map.hpp"
//
// A period-n orbit x_1 -> x_2 -> .. -> x_n -> x_1 is solved for with all its points as unknowns,
// f(x_i) - x_{i+1} = 0, so that no long product of slopes enters the equations; its multipliers are
// the eigenvalues of the product Df(x_n) .. Df(x_1).
#pragma once

#include <functional>
#include <optional>

#include "graze/continuation/branch.hpp"

namespace graze {

struct MapEvaluation {
  Vector image;                 // f, n
  Matrix jacobian;              // df/dx, n x n
  Vector parameter_derivative;  // df/dparameter, n
};

// Nothing where the map cannot be evaluated.
using Map = std::function<std::optional<MapEvaluation>(const Vector& x, double parameter)>;

// Orbits of period `period`; the unknown is (x_1, .., x_period), one after the other.
ZeroProblem periodic_points(const Map& map, int period = 1);

// The solution of period n seen as one of period 2n, where it is a branch point if it doubles
// there: what other_branch() switches from onto the doubled orbits.
BranchPoint twice_round(const BranchPoint& point);

}  // namespace graze
