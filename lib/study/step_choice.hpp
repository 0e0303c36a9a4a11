// The flow that a scene asks for.
#pragma once

#include <optional>

#include "graze/flow/step_setting.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// Size of the modal motion, kg^1/2 m/s (StepSetting::speed): what the start brings along, what the
// forcing gives within a radian, what the motion has at its stops.
double modal_speed(const System& system, const State& start);

// The method of a flow that takes steps; absent: it is exact.
std::optional<StepMethod> step_method(FlowChoice flow);

// How the motion is integrated step by step; absent where it is exact. Its tolerance is that of the
// scene. Throws InputError for a step at which the method is not stable.
std::optional<StepSetting> step_choice(const Scene& scene, const System& system,
                                       const State& start);

// Throws InputError unless the scene's flow is the exact one; `what` is done, e.g. "orbits are
// solved for".
void require_exact_flow(const Scene& scene, const char* what);

}  // namespace graze
