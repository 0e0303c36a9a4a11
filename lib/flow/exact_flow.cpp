#include "graze/flow/exact_flow.hpp"

#include "graze/flow/gap_curve_impl.hpp"

namespace graze {

template class ExactFlow<double>;
template class Arc<double>;
template class GapCurve<double>;
template PlanarNumber<double> resonant_response(const ModeFlow<double>&, const double&,
                                                const double&, const double&);

}  // namespace graze
