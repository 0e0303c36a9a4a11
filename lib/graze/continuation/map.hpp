// Periodic orbits of a map x -> f(x, parameters), as a zero problem for continuation: over one
// parameter for a branch, over two for a locus.
//
//   #include "graze/continuation/map.hpp"
//
// A period-n orbit x_1 -> x_2 -> .. -> x_n -> x_1 is solved for with all its points as unknowns,
// f(x_i) - x_{i+1} = 0, so that no long product of slopes enters the equations; its multipliers are
// the eigenvalues of the product Df(x_n) .. Df(x_1). A(mu) has mu times the x_1 of the last
// equation: A(mu) v = 0 says that v_{i+1} = Df(x_i) v_i and mu v_1 = Df(x_n) v_n.
#pragma once

#include <functional>
#include <optional>

#include "graze/continuation/branch.hpp"

namespace graze {

struct MapEvaluation {
  Vector image;          // f, n
  Matrix jacobian;       // df/dx, n x n
  Matrix by_parameters;  // df/dparameters, n x m
};

struct Map {
  // Returns nullopt when the map cannot be evaluated.
  std::function<std::optional<MapEvaluation>(const Vector& x, Parameters at)> evaluate;
  // The derivatives of left^T df/dx right by (x, parameters), the vectors (n) held fixed: n + m.
  // Returns nullopt likewise. Only loci call it.
  std::function<std::optional<Vector>(const Vector& x, Parameters at, const Vector& left,
                                      const Vector& right)>
      curvature{};
};

// Orbits of period `period`; the unknown is (x_1, .., x_period), one after the other.
ZeroProblem periodic_points(const Map& map, int period = 1);

// The solution of period n as one of period 2n, which is a branch point if it doubles there:
// other_branch() switches from it onto the doubled orbits.
SolutionPoint twice_round(const SolutionPoint& point);

}  // namespace graze
