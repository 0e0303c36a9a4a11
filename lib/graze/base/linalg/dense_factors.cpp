#include "graze/base/linalg/detail/dense_factors.hpp"

#include "graze/base/linalg/detail/dense_factors_impl.hpp"

namespace graze {

template class PivotedLu<double>;
template SingularValues<double> singular_values(const RealMatrix<double>&);
template RealMatrix<double> orthonormal_columns(const RealMatrix<double>&, Eigen::Index);

}  // namespace graze
