#include "graze/flow/exact/extended.hpp"
#include "graze/flow/held/detail/constrained_structure_impl.hpp"
#include "graze/flow/held/detail/exact_phase_impl.hpp"

namespace graze {

template struct ConstrainedStructure<Extended>;
template class ExactPhase<Extended>;
template class FreePhase<Extended>;
template class ConstrainedPhase<Extended>;

}  // namespace graze
