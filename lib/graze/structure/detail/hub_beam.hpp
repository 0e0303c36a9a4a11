// A beam clamped radially to a hub that turns (A. S. Yigit, A. G. Ulsoy, R. A. Scott, J. Sound Vib.
// 137, 1990, equations 15 to 21), in the angle and the beam's mass-normalised clamped modes:
//
//   q'' + s theta'' + [w^2 - theta'^2 (1 - c)] q + g S cos(theta) = ..
//   J theta'' + s.q'' + .. = T,   J = I_R + rho [(l + alpha)^3 - alpha^3]/3
#pragma once

#include "graze/base/vector.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

struct HubBeam {
  double inertia = 0.0;  // J, kg m^2: of the hub and the straight beam
  Vector coupling;       // s, kg^1/2 m, N
  Matrix stiffening;     // c, N x N: of the tension that turning sets up; empty where left out
  Vector pull;           // S, kg^1/2, N: per unit of gravity
  double moment = 0.0;   // rho (alpha l + l^2/2), kg m: per unit of gravity
};

// The hub and beam of a checked scene with a hub.
HubBeam hub_beam(const Scene& scene);

// Small free vibrations of hub and beam together about any angle, the rigid rotation first: x =
// (theta, q) = (angle.y, beam y) with y'' + w^2 y = 0.
struct HubModes {
  Vector omega;  // rad/s, N + 1, ascending from 0
  Vector angle;  // kg^-1/2 m^-1, N + 1
  Matrix beam;   // N x (N + 1)
};

// `omega`: of the clamped beam, rad/s. The relative errors of the frequencies are eps J/(J - s.s),
// where s.s is nearly J if the beam has almost all of the inertia.
HubModes hub_modes(const Vector& omega, const Vector& coupling, double inertia);

}  // namespace graze
