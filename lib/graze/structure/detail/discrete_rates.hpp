// Derivatives of the modes of a structure whose matrices stand in the scene,
//
//   K phi_j = w_j^2 M phi_j,   phi_i^T M phi_j = 1 if i = j else 0:
//
//   2 w_j w_j' = a_jj,   phi_j' = sum_i phi_i c_ij,   a_ij = phi_i.(K' - w_j^2 M') phi_j,
//   c_ij = a_ij/(w_j^2 - w_i^2),   c_jj = -phi_j.M' phi_j/2,
//
// over all modes i of the structure, those that are left out among them (R. L. Fox & M. P. Kapoor,
// AIAA J. 6 (1968) 2426).
#pragma once

#include <map>
#include <vector>

#include "graze/base/vector.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

struct DiscreteRates {
  Vector omega;                   // of the modes kept
  Matrix shapes;                  // on the free degrees of freedom, by the modes kept
  Matrix damping;                 // of Phi^T C Phi
  std::map<int, Vector> inertia;  // as of MatrixModes
  std::vector<Matrix> supports;   // of the modal forces of supports that move, N x 3 each
  // Of the static displacements of the stops, as of MatrixModes; not where the structure is free.
  Matrix flexibility;
  Vector under_gravity;
};

// Of a scene that moves along `direction`. Throws InputError where there is no derivative: two
// modes of one frequency turn into each other, a free motion begins to be held, or degrees of
// freedom have no mass.
DiscreteRates discrete_rates(const Scene& scene, const Scene& direction);

}  // namespace graze
