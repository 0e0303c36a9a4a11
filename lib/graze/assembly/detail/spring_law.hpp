// The contact force of a compliant stop, from what its scene says of it.
#pragma once

#include "graze/contact/contact_force.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// Of a checked scene.
ContactForce spring_law(const Spring& spring);

// Its derivative when the scene's numbers move along `rate`, a spring of the same shape.
ContactForce spring_law_rate(const Spring& spring, const Spring& rate);

}  // namespace graze
