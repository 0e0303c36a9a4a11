// The forces of the stops within a phase.
#pragma once

#include <vector>

#include "graze/flow/exact/detail/contact_phase.hpp"

namespace graze {

// The force of every stop s seconds after the start of the phase, N; 0 where it is open.
void contact_forces(const System& system, const ContactPhase<double>& phase, double s,
                    const State& state, std::vector<double>& forces);
// What every dry friction exerts against +u, likewise.
void friction_forces(const System& system, const ContactPhase<double>& phase, double s,
                     const State& state, std::vector<double>& forces);

}  // namespace graze
