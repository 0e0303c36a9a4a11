// Stops whose stiffness is "residual": the spring of the modes that the scene leaves out. They have
// no inertia worth the name, so that they follow their loads at once,
//
//   u = Phi q + s - R F,   R = G - Phi W^-2 Phi^T,
//
// F the forces of the stops, s what they make of a constant load (residual_response). A contact at
// u = gap is then a spring of 1/R_ii that meets Phi q at the gap less s. What a force at another
// stop moves there, R_ik, whatever that stop is, is left out, and refused where it is not small.
//   R. H. MacNeal, Comput. Struct. 1 (1971) 581-601.
#pragma once

#include <vector>

#include "graze/scene/scene.hpp"
#include "graze/structure/modal_model.hpp"

namespace graze {

// Of one stop.
struct ResidualSpring {
  double stiffness = 0.0;  // N/m; 0 of a stop whose stiffness is not residual
  double shift = 0.0;      // s, m along u
};

// Of every stop of a checked scene; empty where none is residual. Throws InputError where nothing
// is left within what is known of it, and where stops are coupled.
std::vector<ResidualSpring> residual_springs(const Scene& scene, const ModalModel& model);

// Rates along `direction` (see modal_tangent).
std::vector<ResidualSpring> residual_spring_rates(const Scene& scene, const Scene& direction,
                                                  const ModalModel& model, const ModalModel& rate);

// Share of a stop's static flexibility, or of what is left of it, that may be left out: as much as
// an error of the contact's stiffness that is seen in its duration.
inline constexpr double kSeenFlexibility = 0.05;

}  // namespace graze
