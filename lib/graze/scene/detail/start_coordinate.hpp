// The numbers of a scene's start by name: "initial.q.1", "initial.qdot.2", of a hub "initial.angle"
// and "initial.rate", for what looks at a motion from many starts or seeks its start. They are no
// parameters: no orbit depends on them.
#pragma once

#include <string>

#include "graze/scene/scene.hpp"

namespace graze {

// Whether the name is meant as one: it begins with "initial.".
bool names_start_coordinate(const std::string& name);

// The number, in a scene whose start then holds all of them, those not given as zero. Throws
// InputError where the scene has no such number.
double& start_coordinate(Scene& scene, const std::string& name);

// The scene with a parameter or a number of its start changed, and the unit of either. Throw
// InputError as with_parameter and start_coordinate do.
Scene with_number(const Scene& scene, const std::string& name, double value);
std::string number_unit(const Scene& scene, const std::string& name);

}  // namespace graze
