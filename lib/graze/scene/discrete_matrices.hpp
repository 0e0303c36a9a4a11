// The matrices of a structure whose numbers stand in the scene: masses and springs, or matrices row
// by row.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "graze/base/vector.hpp"
#include "graze/fem/dof_label.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// n x n each, n the number of masses or of rows; kg, N s/m, N/m.
struct DiscreteMatrices {
  Matrix mass, damping, stiffness;
};

// Whether they stand in the scene, and not in files.
bool has_own_matrices(const Scene& scene);

// They are linear in the numbers: of a direction of the scene (parameter_direction) they are the
// rates. A spring in series with friction adds a coordinate, behind those of the scene. Requires a
// scene that has them, and passed check_discrete.
DiscreteMatrices discrete_matrices(const Scene& scene, const Scene& numbers);

// How many masses or rows the scene has itself.
int own_coordinates(const Scene& scene);
// The coordinate of what rubs behind a spring in series, of this friction (from 0); its direction
// is none of those that uniform motions have.
inline constexpr int kOfNoPlace = 9;
DofLabel label_of_rubbing(const Scene& scene, std::size_t friction);

// The mass that a text names, from 0: its number, from 1, or its name; -1: the ground, "0" or
// "ground". Returns nullopt where there is none of that name.
std::optional<int> mass_named(const LumpedStructure& lumped, const std::string& text);
// The springs and dashpots between the ground and the mass of a load of the kind "support", N/m and
// N s/m; of a direction of the scene, what these move by.
std::array<double, 2> support_of(const Scene& scene, const HarmonicLoad& load);

// The sentence about a text that names none.
std::string mass_refusal(const LumpedStructure& lumped, const std::string& text,
                         bool may_be_ground);

// Throws InputError where springs, names or rows do not fit each other.
void check_discrete(const Scene& scene);

}  // namespace graze
