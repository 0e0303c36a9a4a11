#include "graze/motion/detail/motion.hpp"

#include "graze/motion/detail/motion_impl.hpp"

namespace graze {

template class Motion<double>;

}  // namespace graze
