// The orbit of a solution of the shooting equations under its shortest period: several rounds of a
// shorter orbit solve the equations of the longer pattern too.
#pragma once

#include <optional>

#include "graze/orbit/orbit.hpp"
#include "graze/orbit/solve.hpp"

namespace graze {

// Nothing where the solution repeats a shorter pattern whose own equations do not converge there.
std::optional<Orbit> minimal_orbit(const System& system, const ShootingProblem& problem,
                                   const ShootingSolution& solution);

}  // namespace graze
