#include "graze/flow/contact_phase.hpp"

#include "graze/flow/contact_phase_impl.hpp"

namespace graze {

template class ContactPhase<double>;

}  // namespace graze
