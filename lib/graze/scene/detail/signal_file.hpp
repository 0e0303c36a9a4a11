// Courses of loads over time, from files.
#pragma once

#include "graze/scene/scene.hpp"

namespace graze {

// Reads the signals of the loads. Throws InputError (file:line:column) where a table is not one of
// instants and values.
void read_signals(Scene& scene);

}  // namespace graze
