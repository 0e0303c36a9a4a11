// The structure of a scene in words, for the list of what is simulated.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graze/scene/scene.hpp"
#include "graze/structure/element_accuracy.hpp"

namespace graze {

// Names of effects and what they are, the structure itself first, in the order of the list. Of
// modes that are found by elements also how.
std::vector<std::pair<std::string, std::string>> structure_effects(
    const Scene& scene, const std::optional<ElementAccuracy>& elements);

}  // namespace graze
