// The numbers of a scene's start by name: "initial.q.1", "initial.qdot.2", with a hub
// "initial.angle" and "initial.rate", for maps over starts and searches of a start. They are no
// parameters: no orbit depends on them.
#pragma once

#include <string>

#include "graze/scene/scene.hpp"

namespace graze {

// Whether the name is meant as one: it begins with "initial.".
bool names_start_coordinate(const std::string& name);

// A reference to the number; the scene's start is given all of them first, missing ones as zero.
// Throws InputError where the scene has no such number.
double& start_coordinate(Scene& scene, const std::string& name);

// The scene with a parameter or a number of its start changed, and the unit of either. Throw
// InputError as with_parameter and start_coordinate do.
Scene with_number(const Scene& scene, const std::string& name, double value);
std::string number_unit(const Scene& scene, const std::string& name);

}  // namespace graze
