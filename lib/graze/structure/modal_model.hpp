// A structure as its mass-normalised modes see it:
//
//   q_j'' + 2 delta_j q_j' + sum_i coupling_ji q_i' + omega_j^2 q_j
//       = sum_k participations_kj * (harmonic load k) + inertia_j * (gravity)
//         + sum_k loads_kj * (force k),
//   u(x, t) = sum phi_j(x) q_j
//
// Damping acts on the velocity relative to the clamp. The load's unit is that of the forcing:
// uniform acceleration for `base`, force per length for `distributed`, force for `point`, 1 for
// `modal`. Gravity is a uniform acceleration along +u, projected like the load.
#pragma once

#include <optional>
#include <vector>

#include "graze/base/vector.hpp"
#include "graze/scene/scene.hpp"
#include "graze/structure/element_accuracy.hpp"

namespace graze {

struct ModalModel {
  Vector omega;          // natural frequencies, rad/s, N
  Vector delta;          // decay rates, 1/s, N
  Matrix coupling;       // of the damping, 1/s, N x N with a zero diagonal; empty: none
  Matrix coordinates;    // of the masses or degrees of freedom by all modes, N x N, kg^-1/2; or none
  std::vector<Vector> participations;  // modal force per unit of each harmonic load, N each
  // Of supports that move, in the order of their loads: modal force per unit of their velocity and
  // of their acceleration, N x 2 each.
  std::vector<Matrix> following;
  Vector inertia;  // modal force per unit of uniform acceleration, kg^1/2, N; empty: no gravity
  std::vector<Vector> shapes;  // phi_j at each stop, kg^-1/2, N each
  std::vector<Vector> loads;   // phi_j at each constant force, kg^-1/2, N each
  std::vector<Vector> frictions;  // at each dry friction, likewise
  std::vector<Vector> springs;    // along each spring in series with one; empty where there is none
  Matrix collocation;          // Phi_ij = phi_j(x_i), N x N; empty where nothing collocates
  // nullopt when the modes have a closed form or are given.
  std::optional<ElementAccuracy> elements;
};

// The model of a checked scene. Only what the scene calls for is computed. Throws InputError where
// a compressed beam buckles, or where no elements that could be afforded resolve the modes.
ModalModel modal_model(const Scene& scene);

// Derivative of every number of `model` when the scene moves along `direction` (a scene of the same
// shape that holds the rate of change of each number; see parameter_direction). Throws InputError
// where there is none: two modes of one frequency turn into each other, or two things at one place
// part.
ModalModel modal_tangent(const Scene& scene, const ModalModel& model, const Scene& direction);

// Rows on the modal coordinates at a place x of a beam, a string or a bar: of the displacement, and
// of the strain where the structure has one (-h/2 u'' of a beam, u' of a bar).
std::vector<Vector> shapes_at(const Scene& scene, const std::vector<double>& places);
Vector strain_row(const Scene& scene, double x);

// The modal coordinates of a beam, a string or a bar in a shape through points: `values` at rising
// `places`, straight lines between them, even beyond.
Vector modal_coordinates(const Scene& scene, const std::vector<double>& places,
                         const std::vector<double>& values);

// The mass of a beam, a string or a bar with its point masses, kg.
double total_mass(const Scene& scene);

// Whether the scene's forcing, gravity or impulses go through the collocation matrix.
bool uses_collocation(const Scene& scene);

}  // namespace graze
