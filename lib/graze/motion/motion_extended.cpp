#include "graze/flow/exact/detail/products_extended.hpp"
#include "graze/flow/exact/extended.hpp"
#include "graze/motion/detail/motion_impl.hpp"

namespace graze {

template class Motion<Extended>;

}  // namespace graze
