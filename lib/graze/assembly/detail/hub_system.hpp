// The system of a beam on a rotating hub.
#pragma once

#include "graze/scene/scene.hpp"
#include "graze/structure/modal_model.hpp"
#include "graze/system/system.hpp"

namespace graze {

// Requires a checked scene with a hub; `model` is that of its clamped beam.
System assemble_on_hub(const Scene& scene, const ModalModel& model);

// The coordinates y of an angle, rad, and the beam's modal coordinates q; likewise for their rates.
Vector turning_coordinates(const Rotation& rotation, double angle, const Vector& q);

}  // namespace graze
