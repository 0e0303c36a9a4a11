// The contact force of a compliant stop, from its scene.
#pragma once

#include "graze/contact/contact_force.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// The spring with its stiffness as a number; `stiffness` (N/m) is used where it is residual.
Spring as_given(const Spring& spring, double stiffness);

// The rate of as_given.
Spring rate_as_given(const Spring& rate, double stiffness_rate);

// The law of a spring of a checked scene, as as_given returns it.
ContactForce spring_law(const Spring& spring);

// Its derivative when the scene's numbers move along `rate`, a spring of the same shape.
ContactForce spring_law_rate(const Spring& spring, const Spring& rate);

}  // namespace graze
