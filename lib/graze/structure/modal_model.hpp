// A structure as its mass-normalised modes see it:
//
//   q_j'' + 2 delta_j q_j' + omega_j^2 q_j = participation_j * (load) + inertia_j * (gravity),
//   u(x, t) = sum phi_j(x) q_j
//
// Damping acts on the velocity relative to the clamp. The load's unit is that of the forcing:
// uniform acceleration for `base`, force per length for `distributed`, 1 for `modal`. Gravity is a
// uniform acceleration along +u, projected like the load.
#pragma once

#include <vector>

#include "graze/base/vector.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

struct ModalModel {
  Vector omega;          // natural frequencies, rad/s, N
  Vector delta;          // decay rates, 1/s, N
  Vector participation;  // modal force per unit load, N; empty without forcing
  Vector inertia;  // modal force per unit of uniform acceleration, kg^1/2, N; empty: no gravity
  std::vector<Vector> shapes;  // phi_j at each stop, kg^-1/2, N each
  Matrix collocation;          // Phi_ij = phi_j(x_i), N x N; empty where nothing collocates
};

// The model of a checked scene. Only what the scene calls for is computed.
ModalModel modal_model(const Scene& scene);

// Derivative of every number of `model` when the scene moves along `direction` (a scene of the same
// shape that holds the rate of change of each number; see parameter_direction).
ModalModel modal_tangent(const Scene& scene, const ModalModel& model, const Scene& direction);

// Whether the scene's forcing, gravity or impulses go through the collocation matrix.
bool uses_collocation(const Scene& scene);

}  // namespace graze
