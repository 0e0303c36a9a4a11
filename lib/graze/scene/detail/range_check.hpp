// What every key asks of its own value.
#pragma once

#include "graze/scene/scene.hpp"

namespace graze {

// Numbers in their ranges, lists of the right length, nothing that does not apply. Throws
// InputError.
void check_ranges(const Scene& scene);

}  // namespace graze
