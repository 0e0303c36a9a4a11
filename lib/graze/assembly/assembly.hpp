// From a scene to its assembled system, and the derivative of the system by a parameter.
#pragma once

#include <string>

#include "graze/scene/scene.hpp"
#include "graze/structure/modal_model.hpp"
#include "graze/system/system.hpp"

namespace graze {

// Assembles a checked scene.
System assemble(const Scene& scene);

// Derivative of every number of the assembled system by a parameter of the scene, per unit of it.
// Throws InputError when the scene has no such parameter.
System system_tangent(const Scene& scene, const std::string& parameter);

// The same from a given modal model, for many systems of one structure. `model` is that of the
// scene, `direction` the rate of change of the scene's numbers (parameter_direction), `rate` the
// model's rate along it, `system` the system assembled from `scene` and `model`.
System assemble(const Scene& scene, const ModalModel& model);
System system_tangent(const Scene& scene, const Scene& direction, const ModalModel& model,
                      const ModalModel& rate, const System& system);

}  // namespace graze
