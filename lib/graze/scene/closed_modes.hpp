// Which structures have modes in closed form.
#pragma once

#include "graze/scene/scene.hpp"

namespace graze {

// Other structures are solved by elements, whose time grows with the third power of the modes.
inline constexpr int kMostElementModes = 600;

// Whether the modes have a closed form: of a uniform clamped-free beam without tension, and of a
// uniform string or bar; none of them with supports or masses between its ends.
bool has_closed_modes(const Scene& scene);

// Whether a length of the section changes along its piece.
bool is_tapered(const Section& section);

}  // namespace graze
