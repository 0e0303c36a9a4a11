// The flow that a scene asks for.
#pragma once

#include <optional>
#include <string>

#include "graze/flow/stepped/step_setting.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// Size of the modal motion, kg^1/2 m/s (StepSetting::speed): the largest of the initial speed, the
// speed that the forcing gives within a radian, and the speed at the stops.
double modal_speed(const System& system, const State& start);

// The method of a flow that takes steps; nullopt for the exact flow.
std::optional<StepMethod> step_method(FlowChoice flow);

// The flow that a scene runs on, and why: a clause without a full stop.
//
// "auto" is decided by these rules, from what `graze cost` measures on the shipped scenes
// (docs/accuracy.md; tests/study/flow_decision_test.cpp holds them to it):
//   - where every effect is linear between impacts the exact flow meets any tolerance down to the
//     rounding of the impacts, and costs less than any setting of the others that does;
//   - contacts on linear springs of up to 128 modes have closed forms too; at other compliant stops
//     the exact flow integrates each contact to 1e-14 of its speed a step: it is the most careful
//     there is, but steps as long as a tolerance allows may cost less, and over many contacts that
//     magnify errors it may exceed the tolerance;
//   - on a hub nothing has a closed form: the extrapolation method of Bulirsch and Stoer costs a
//     few times what the others do at their coarsest, and loses nothing.
struct FlowDecision {
  FlowChoice flow = FlowChoice::kExact;  // never kAuto
  std::string reason;
};
FlowDecision flow_decision(const Scene& scene);

// A method's default steps: the longest stable ones, and where the motion has no rate of its own
// (free masses), by the time that it takes to its stops.
StepSetting stable_steps(const System& system, const State& start, StepMethod method);

// How the motion is integrated step by step; nullopt for the exact flow. Its tolerance is that of
// the scene. Throws InputError for a step at which the method is not stable.
std::optional<StepSetting> step_choice(const Scene& scene, const System& system,
                                       const State& start);

// Throws InputError where the structure is on a hub, which has no periodic forcing; `what` is the
// task in the message, e.g. "orbits are solved for".
void require_clamp(const Scene& scene, const char* what);

// The same, and unless the scene's flow is the exact one.
void require_exact_flow(const Scene& scene, const char* what);

}  // namespace graze
