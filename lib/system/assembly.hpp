// Assembly from a modal model that is at hand, for many systems of one structure.
#pragma once

#include "graze/structure/modal_model.hpp"
#include "graze/system/system.hpp"

namespace graze {

// As assemble() and system_tangent() of system.hpp. `model` is that of the scene, `direction` the
// rate of change of its numbers (parameter_direction), `rate` the model's along it, `system` what
// is assembled of them.
System assemble(const Scene& scene, const ModalModel& model);
System system_tangent(const Scene& scene, const Scene& direction, const ModalModel& model,
                      const ModalModel& rate, const System& system);

}  // namespace graze
