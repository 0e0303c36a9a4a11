// Stops whose stiffness is "residual": the spring of the modes that the scene leaves out. These
// modes have negligible inertia, so that they follow their loads at once,
//
//   u = Phi q + s - R F,   R = G - Phi W^-2 Phi^T,
//
// F the forces of the stops, s the displacement under a constant load (residual_response). A
// contact at u = gap is then a spring of 1/R_ii that meets Phi q at the gap less s. The coupling
// R_ik to the force at any other stop is neglected; scenes in which it is not small are refused.
//   R. H. MacNeal, Comput. Struct. 1 (1971) 581-601.
#pragma once

#include <vector>

#include "graze/scene/scene.hpp"
#include "graze/structure/modal_model.hpp"

namespace graze {

// The residual spring of one stop.
struct ResidualSpring {
  double stiffness = 0.0;  // N/m; 0 of a stop whose stiffness is not residual
  double shift = 0.0;      // s, m along u
};

// One for every stop of a checked scene; empty where none is residual. Throws InputError where the
// residual flexibility is within its uncertainty, and where stops are coupled.
std::vector<ResidualSpring> residual_springs(const Scene& scene, const ModalModel& model);

// Rates along `direction` (see modal_tangent).
std::vector<ResidualSpring> residual_spring_rates(const Scene& scene, const Scene& direction,
                                                  const ModalModel& model, const ModalModel& rate);

// Share of a stop's static flexibility, or of its residual one, that may be neglected: an error of
// the contact's stiffness of this size becomes visible in the duration of contact.
inline constexpr double kSeenFlexibility = 0.05;

}  // namespace graze
