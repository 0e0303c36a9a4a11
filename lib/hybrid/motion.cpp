#include "graze/hybrid/motion.hpp"

#include "graze/hybrid/motion_impl.hpp"

namespace graze {

template class Motion<double>;

}  // namespace graze
