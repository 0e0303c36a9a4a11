#include "graze/flow/held/detail/exact_phase.hpp"

#include "graze/flow/held/detail/exact_phase_impl.hpp"

namespace graze {

template class ExactPhase<double>;
template class FreePhase<double>;
template class ConstrainedPhase<double>;

}  // namespace graze
