// The deflection of a structure under constant loads, and how much of it its modes represent.
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

// Returns nullopt when only the modes of the checked scene's structure are known (given as such, or
// a string with given frequencies), or when it rotates with a hub.
std::optional<StaticResponse> static_response(const Scene& scene);

// The response of the scene's modes: sum of phi phi^T/w^2 over those that are not rigid.
StaticResponse static_response_of_modes(const ModalModel& model);

// The difference, the response of the modes left out; `whole` is the structure's.
StaticResponse residual_response(const StaticResponse& whole, const ModalModel& model);

// Its rate along `direction` (see modal_tangent). Throws InputError where there is none: a stop of
// a string or a bar sits at the same place as something else, and only one of them moves.
StaticResponse residual_response_rate(const Scene& scene, const Scene& direction,
                                      const ModalModel& model, const ModalModel& rate);

// Bound on the error of the residual flexibility at each stop, m/N: by rounding, and by the
// uncertainty of the frequencies.
Vector residual_uncertainty(const Scene& scene, const StaticResponse& whole,
                            const ModalModel& model);

// Rigid motions that the structure is free to make, whether modes are kept of all of them or not.
int free_motions(const Scene& scene, const ModalModel& model);

}  // namespace graze
