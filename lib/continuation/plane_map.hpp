// Periodic orbits of a map x -> f(x, p, q) with two parameters as a plane problem (locus.hpp).
//
//   #include "graze/continuation/plane_map.hpp"
//
// As in map.hpp all points of an orbit x_1 -> .. -> x_n -> x_1 are unknowns, f(x_i) - x_{i+1} = 0;
// A(mu) has mu times the x_1 of the last equation: A(mu) v = 0 says that v_{i+1} = Df(x_i) v_i and
// mu v_1 = Df(x_n) v_n.
#pragma once

#include <functional>
#include <optional>

#include "graze/continuation/plane_problem.hpp"

namespace graze {

struct PlaneMapEvaluation {
  Vector image;                // f, n
  Matrix jacobian;             // df/dx, n x n
  Vector by_first, by_second;  // df/dp, df/dq, n
};

struct PlaneMap {
  // Nothing where the map cannot be evaluated.
  std::function<std::optional<PlaneMapEvaluation>(const Vector& x, double p, double q)> evaluate;
  // The derivatives of left^T df/dx right by (x, p, q), the vectors (n) held fixed: n + 2. Nothing
  // as above.
  std::function<std::optional<Vector>(const Vector& x, double p, double q, const Vector& left,
                                      const Vector& right)>
      curvature;
};

// Orbits of period `period`; the unknown is (x_1, .., x_period), one after the other.
PlaneProblem periodic_points(const PlaneMap& map, int period = 1);

}  // namespace graze
