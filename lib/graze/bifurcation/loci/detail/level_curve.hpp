// Loci of orbits at which a number of theirs has a given value (UZ), or is extreme along the branch
// over the first parameter (EX). The number is measured and has no derivatives of its own; where
// the motion does not close it may not even exist. It is taken at the nearest orbit, and its slope
// from orbits beside it: differences, which decide on how quickly Newton's method converges and not
// on where.
#pragma once

#include "graze/bifurcation/loci/detail/orbit_curve.hpp"
#include "graze/bifurcation/problem/detail/remembered.hpp"
#include "graze/bifurcation/problem/orbit_level.hpp"

namespace graze {

class LevelCurve : public OrbitCurve {
 public:
  // Refers to both; u has n entries. `units`: the lengths of the ranges of the parameters.
  LevelCurve(const OrbitProblem& equations, Eigen::Index n, const OrbitLevel& level,
             std::array<double, 2> units);

 private:
  // An orbit as (u, first/range, second/range), n + 2, and the two directions, columns, of those
  // beside it.
  struct Place {
    Vector x;
    Matrix beside;
  };
  std::optional<Place> nearest_orbit(Vector x) const;
  std::optional<double> excess(const Place& at) const;
  // The excess, or its slope along the branch.
  std::optional<double> value(const Place& at) const;
  std::optional<Condition> condition(const Vector& x) const;
  std::array<double, 2> values_of(const Vector& x) const;

  const OrbitLevel& level_;
  double second_unit_;
  mutable Remembered<Vector, std::optional<Condition>> remembered_;
};

}  // namespace graze
