// Warnings about a scene that can be simulated nevertheless.
#pragma once

#include <string>
#include <vector>

#include "graze/scene/scene.hpp"
#include "graze/structure/modal_model.hpp"
#include "graze/system/system.hpp"

namespace graze {

// Sentences about ill-conditioned collocation points, an impulse law that can add energy, .. Empty
// where there is nothing to warn of.
std::vector<std::string> system_warnings(const Scene& scene, const System& system);

// Condition number of the collocation matrix in force, or 0 where nothing collocates.
double collocation_condition(const ModalModel& model);

}  // namespace graze
