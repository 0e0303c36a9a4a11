// The motion that meets no stop: the response of the free structure to its forcing and load. It is
// a periodic orbit without impacts as long as it stays clear.
//
//   q = offset + Re(amplitude e^{i theta}),   amplitude_j = f_j/(w_j^2 - W^2 + 2 i delta_j W),
//   offset_j = c_j/w_j^2
//
// where damping couples no modes; else (w^2 - W^2 + i W D) amplitude = f. Further harmonics add
// their own, of k theta and k W.
#pragma once

#include <optional>

#include "graze/orbit/closed_form/harmonic_sum.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {

struct Response {
  ComplexVector amplitude;  // kg^1/2 m, N
  Vector offset;            // kg^1/2 m, N
  struct Part {
    int order = 1;
    ComplexVector amplitude;
  };
  std::vector<Part> harmonics{};  // beside the first

  // Displacements and velocities at forcing phase theta, rad.
  State at(double theta, double frequency) const;
  // The gap of a stop, m, over the forcing phase.
  HarmonicSum gap(const Stop& stop) const;
  // Distance of a stop from the motion, m; negative: the depth of penetration.
  double clearance(const Stop& stop) const;
  // The phase at which the motion is nearest to it, rad.
  double nearest_phase(const Stop& stop) const;
  // The smallest such distance; nullopt when there are no stops.
  std::optional<double> clearance(const std::vector<Stop>& stops) const;
};

// Returns nullopt when there is no such motion, or more than one: at an undamped resonance, for a
// free mass; under a signal, which is no harmonic; and with dry friction. Requires forcing.
std::optional<Response> response_of(const System& system);

// Derivative of the response by the parameter of this tangent.
Response response_rate(const System& system, const System& tangent, const Response& response);

// Multipliers of the map over a forcing period, largest modulus first; in closed form.
std::vector<Eigenvalue> response_multipliers(const System& system);

// The response as an orbit, with a section at forcing phase 0; admissible when it is clear of every
// stop.
Orbit response_orbit(const System& system, const Response& response);

}  // namespace graze
