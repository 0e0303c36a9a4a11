// All of the room that 50 digits need: to read what defines the scalar takes the compiler longer
// than any part of it.
#include "graze/base/linalg/detail/dense_factors_impl.hpp"
#include "graze/flow/exact/detail/arc_curve_impl.hpp"
#include "graze/flow/exact/detail/products_extended_impl.hpp"
#include "graze/flow/exact/extended.hpp"
#include "graze/flow/held/detail/constrained_structure_impl.hpp"
#include "graze/flow/held/detail/exact_phase_impl.hpp"

namespace graze {

template class PivotedLu<Extended>;
template SingularValues<Extended> singular_values(const RealMatrix<Extended>&);
template RealMatrix<Extended> orthonormal_columns(const RealMatrix<Extended>&, Eigen::Index);
template class CurveTerms<Extended>;
template class ExactFlow<Extended>;
template class Arc<Extended>;
template class ArcCurve<Extended>;
template CurvePoint<Extended> observed(const Observable<Extended>&, const Extended&,
                                       const RealVector<Extended>&, const RealVector<Extended>&);
template struct ConstrainedStructure<Extended>;
template class ExactPhase<Extended>;
template class FreePhase<Extended>;
template class ConstrainedPhase<Extended>;

}  // namespace graze
