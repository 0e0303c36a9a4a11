// The phase in closed form of a structure that moves freely or is held by closed stops.
#pragma once

#include <memory>

#include "graze/flow/held/detail/exact_phase.hpp"

namespace graze {

std::unique_ptr<ExactPhase<double>> exact_phase(const System& system, const PhaseKey& key);

}  // namespace graze
