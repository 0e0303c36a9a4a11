// The motion that meets no stop: the response of the free structure to its forcing and load. It is
// a periodic orbit without impacts as long as it stays clear.
//
//   q = offset + Re(amplitude e^{i theta}),   amplitude_j = f_j/(w_j^2 - W^2 + 2 i delta_j W),
//   offset_j = c_j/w_j^2
#pragma once

#include <optional>

#include "graze/orbit/problem/orbit.hpp"

namespace graze {

struct Response {
  ComplexVector amplitude;  // kg^1/2 m, N
  Vector offset;            // kg^1/2 m, N

  // Displacements and velocities at forcing phase theta, rad.
  State at(double theta, double frequency) const;
  // How far a stop is from the motion, m; negative: by how much it penetrates.
  double clearance(const Stop& stop) const;
  // From the nearest of them; nothing where there are none.
  std::optional<double> clearance(const std::vector<Stop>& stops) const;
};

// Nothing where there is none, or more than one: at an undamped resonance, of a free mass.
// Requires forcing.
std::optional<Response> response_of(const System& system);

// How it moves with a parameter that moves the system along this tangent.
Response response_rate(const System& system, const System& tangent, const Response& response);

// Of the map over a forcing period, largest modulus first; in closed form.
std::vector<Eigenvalue> response_multipliers(const System& system);

// The orbit, with a section at forcing phase 0; admissible where it is clear of every stop.
Orbit response_orbit(const System& system, const Response& response);

}  // namespace graze
