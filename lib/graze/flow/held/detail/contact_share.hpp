// How closed stops share the load against them, lambda = (B^T D)^-1 B^T f with f the free
// acceleration, B the rows and D the directions of the stops; and its derivative by a parameter.
#pragma once

#include <vector>

#include "graze/flow/exact/motion_state.hpp"
#include "graze/system/system.hpp"

namespace graze {

// The rows or the directions of some stops, N x k.
Matrix rows_of(const System& system, const std::vector<int>& stops);
Matrix directions_of(const System& system, const std::vector<int>& stops);

// The row along which the force of a compressed spring pushes, with that of the friction that
// slides there: b + sum of +-mu t. `frictions`: as in a PhaseKey.
Vector pushing_row(const System& system, int stop, const std::vector<Contact>& frictions);

// (B^T D)^-1 B^T, k x N. Requires independent rows.
Matrix contact_share(const System& system, const std::vector<int>& closed);
// Its derivative along the system's tangent.
Matrix contact_share_rate(const System& system, const System& tangent,
                          const std::vector<int>& closed);

// P = 1 - D (B^T D)^-1 B^T, by which closed stops leave P f of the free acceleration f; 1 without
// any.
Matrix held_projection(const System& system, const std::vector<int>& closed);
// Its derivative along the system's tangent.
Matrix held_projection_rate(const System& system, const System& tangent,
                            const std::vector<int>& closed);

}  // namespace graze
