// Loci of grazing: the curves in the plane of two parameters along which an orbit touches a stop.
// The touch is an impact at zero speed, so that they are solutions of the shooting equations with
// one more,
//
//   row.q'_i = 0   at the impact i that touches,
//
// regular where the gap has a simple minimum there. A touch does not change the motion: its
// restitution does not matter.
#pragma once

#include "graze/bifurcation/loci/detail/orbit_curve.hpp"
#include "graze/bifurcation/problem/detail/flight_equations.hpp"

namespace graze {

class FlightGrazing : public OrbitCurve {
 public:
  // For the impact `grazing`. The multipliers are those of the orbit without its grazing contact,
  // none where it has no other impact. `unit`: as of OrbitCurve.
  FlightGrazing(const FlightEquations& equations, std::size_t grazing, double unit);

 private:
  std::optional<Condition> speed(const Vector& y, double second) const;
  std::vector<Eigenvalue> multipliers(const Vector& y, double second, ErrorBounds errors) const;

  const FlightEquations& flights_;
  std::size_t grazing_;
};

}  // namespace graze
