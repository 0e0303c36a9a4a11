#include "graze/base/linalg/detail/dense_factors_impl.hpp"
#include "graze/flow/exact/extended.hpp"

namespace graze {

template class PivotedLu<Extended>;
template SingularValues<Extended> singular_values(const RealMatrix<Extended>&);
template RealMatrix<Extended> orthonormal_columns(const RealMatrix<Extended>&, Eigen::Index);

}  // namespace graze
