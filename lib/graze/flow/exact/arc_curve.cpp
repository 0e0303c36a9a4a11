#include "graze/flow/exact/detail/arc_curve.hpp"

#include "graze/flow/exact/detail/arc_curve_impl.hpp"

namespace graze {

template class ExactFlow<double>;
template class Arc<double>;
template class ArcCurve<double>;
template CurvePoint<double> observed(const Observable<double>&, const double&,
                                     const RealVector<double>&, const RealVector<double>&);
template PlanarNumber<double> forced_response(const ModeFlow<double>&, const double&, const double&,
                                              const double&);

}  // namespace graze
