// A state of a structure as another program writes it.
#pragma once

#include <string>

#include "graze/scene/scene.hpp"
#include "graze/system/system.hpp"

namespace graze {

// The first row of a table, which must be at t = 0: the time, and displacements and velocities of
// the masses or degrees of freedom, or else the modal coordinates, in SI units. `system`: that of
// the scene. Throws FileError where the table cannot be read, InputError where it does not fit the
// scene.
State state_in_table(const std::string& file, Scene scene, const System& system);

}  // namespace graze
