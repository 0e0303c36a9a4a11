// A structure whose stops move itself, beside its system, which moves by c less (carried).
#pragma once

#include "graze/flow/held/detail/constrained_structure.hpp"

namespace graze {

// Its velocity and the loads on it, both as forms in the coordinates y of a phase and their rates,
// N x m: place y + rate y'. Of the load that is the first harmonic only the amplitude is given.
struct StructureForms {
  Matrix place, rate;
  Vector forcing;
  Matrix force_place, force_rate;
};
StructureForms structure_forms(const System& system, const ConstrainedStructure<double>& structure);

}  // namespace graze
