// What the schema requires of every single value.
#pragma once

#include "graze/scene/scene.hpp"

namespace graze {

// Requires numbers in their ranges, lists of the right length, and no key that does not apply.
// Throws InputError.
void check_ranges(const Scene& scene);

}  // namespace graze
