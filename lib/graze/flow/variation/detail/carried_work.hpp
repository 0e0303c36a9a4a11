// Works on a structure whose stops move, and which therefore moves by c more than its system does
// (NaturalModes::carried): the loads act on what it really is, and stops that move do work too.
#pragma once

#include "graze/flow/held/detail/coupled_phase.hpp"
#include "graze/flow/variation/work.hpp"

namespace graze {

// Adds the works along the phase's arc over s seconds, but that of the constant load.
void add_carried_work(const System& system, const ExactPhase<double>& phase, double s, Work& work);

// The work of the constant load and of stops, as the structure jumps from one state of the system to
// another at forcing phase theta, beside what the system sees of it. Requires
// stops that move.
void add_carried_jump(const System& system, double theta, const State& before, const State& after,
                      Work& work);

}  // namespace graze
