#include "graze/flow/extended.hpp"
#include "graze/hybrid/motion_impl.hpp"

namespace graze {

template class Motion<Extended>;

}  // namespace graze
