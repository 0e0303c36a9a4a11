// The contact force of a compliant stop, from what its scene says of it.
#pragma once

#include "graze/contact/contact_force.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// The spring of a stop that is given a stiffness; a residual one has that of its law (N/m).
Spring as_given(const Spring& spring, double stiffness);

// And its rate.
Spring rate_as_given(const Spring& rate, double stiffness_rate);

// Of a checked scene, as given.
ContactForce spring_law(const Spring& spring);

// Its derivative when the scene's numbers move along `rate`, a spring of the same shape.
ContactForce spring_law_rate(const Spring& spring, const Spring& rate);

}  // namespace graze
