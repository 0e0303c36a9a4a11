// What a structure gives way under constant loads, and how much of that its modes know of.
#pragma once

#include <optional>

#include "graze/structure/modal_model.hpp"

namespace graze {

// Static displacements along u at the stops, relative to the rigid motions where the structure is
// free to move (inertia relief).
struct StaticResponse {
  Matrix flexibility;    // m/N, stops by stops: of stop i under 1 N at stop k
  Vector under_gravity;  // s^2, of every stop under a uniform acceleration of 1 m/s^2; empty
                         // without gravity
};

// Of a checked scene. Nothing where the structure is known by its modes alone (given as such, or a
// string with given frequencies), or turns with a hub.
std::optional<StaticResponse> static_response(const Scene& scene);

// What the scene's modes make of it: sum of phi phi^T/w^2 over those that are not rigid.
StaticResponse static_response_of_modes(const ModalModel& model);

// The difference, which the modes left out make; `whole` is the structure's.
StaticResponse residual_response(const StaticResponse& whole, const ModalModel& model);

// Its rate along `direction` (see modal_tangent). Throws InputError where there is none: a stop of
// a string or a bar sits at the same place as something else, and only one of them moves.
StaticResponse residual_response_rate(const Scene& scene, const Scene& direction,
                                      const ModalModel& model, const ModalModel& rate);

// How far the flexibility that is left at each stop may be wrong, m/N: by rounding, and by what is
// not known of the frequencies.
Vector residual_uncertainty(const Scene& scene, const StaticResponse& whole,
                            const ModalModel& model);

// Rigid motions that the structure is free to make, whether modes are kept of all of them or not.
int free_motions(const Scene& scene, const ModalModel& model);

}  // namespace graze
