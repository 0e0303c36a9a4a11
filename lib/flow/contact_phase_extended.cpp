#include "graze/flow/contact_phase_impl.hpp"
#include "graze/flow/extended.hpp"

namespace graze {

template class ContactPhase<Extended>;

}  // namespace graze
