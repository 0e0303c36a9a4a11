#include "graze/base/linalg/detail/dense_factors.hpp"

#include "graze/base/linalg/detail/dense_factors_impl.hpp"

namespace graze {

template class PivotedLu<double>;
template Matrix orthonormal_columns(const Matrix&, Eigen::Index);

}  // namespace graze
