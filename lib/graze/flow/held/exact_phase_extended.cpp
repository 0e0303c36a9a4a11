#include "graze/flow/exact/extended.hpp"
#include "graze/flow/held/detail/exact_phase_impl.hpp"
#include "graze/flow/held/detail/held_structure_impl.hpp"

namespace graze {

template struct HeldStructure<Extended>;
template class ExactPhase<Extended>;
template class FreePhase<Extended>;
template class HeldPhase<Extended>;

}  // namespace graze
