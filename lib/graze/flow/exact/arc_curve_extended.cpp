#include "graze/flow/exact/detail/arc_curve_impl.hpp"
#include "graze/flow/exact/extended.hpp"

namespace graze {

template class CurveTerms<Extended>;
template class ExactFlow<Extended>;
template class Arc<Extended>;
template class ArcCurve<Extended>;
template CurvePoint<Extended> observed(const Observable<Extended>&, const Extended&,
                                       const RealVector<Extended>&, const RealVector<Extended>&);

}  // namespace graze
