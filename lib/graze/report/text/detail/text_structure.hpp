// The structure of a scene in words, for the list of simulated effects.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graze/scene/scene.hpp"
#include "graze/structure/element_accuracy.hpp"

namespace graze {

// Names and descriptions of effects, the structure itself first, in the order of the list. For
// modes by elements with their accuracy.
std::vector<std::pair<std::string, std::string>> structure_effects(
    const Scene& scene, const std::optional<ElementAccuracy>& elements);

}  // namespace graze
