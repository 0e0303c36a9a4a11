#include "graze/flow/extended.hpp"
#include "graze/flow/gap_curve_impl.hpp"

namespace graze {

template class ExactFlow<Extended>;
template class Arc<Extended>;
template class GapCurve<Extended>;

}  // namespace graze
