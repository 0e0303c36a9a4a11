// The rules between the keys of a beam, a string or a bar, and between it and the rest of the
// scene. All throw InputError.
#pragma once

#include "graze/scene/scene.hpp"

namespace graze {

// Sections, pieces, ends, supports and masses.
void check_span(const Scene& scene);

// Damping, forcing, stops, probes, projection and hub, as far as the structure decides.
void check_on_span(const Scene& scene);

}  // namespace graze
