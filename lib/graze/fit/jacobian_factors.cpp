#include "graze/fit/detail/jacobian_factors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "graze/base/linalg/detail/dense_factors.hpp"

namespace graze {

JacobianFactors::JacobianFactors(const Matrix& jacobian, double error)
    : lengths_(jacobian.colwise().norm().transpose()) {
  const Eigen::Index n = jacobian.cols();
  Matrix scaled = jacobian;
  for (Eigen::Index j = 0; j < n; ++j)
    if (lengths_[j] > 0.0) scaled.col(j) /= lengths_[j];
  // Full right vectors also where there are fewer rows than columns.
  if (scaled.rows() < n) {
    scaled.conservativeResize(n, n);
    scaled.bottomRows(n - jacobian.rows()).setZero();
  }
  SingularValues<double> factors = singular_values<double>(scaled);
  left_ = factors.left.topRows(jacobian.rows());
  values_ = std::move(factors.values);
  right_ = std::move(factors.right);
  // Errors e of the columns change a singular value by at most e sqrt(n).
  const double rounding =
      static_cast<double>(std::max(jacobian.rows(), n)) * std::numeric_limits<double>::epsilon();
  const double known = std::max(error, rounding) * std::sqrt(static_cast<double>(n));
  rank_ = (values_.array() > known).count();
}

Vector JacobianFactors::step(const Vector& residual) const {
  const Vector along = left_.leftCols(rank_).transpose() * residual;
  const Vector scaled = right_.leftCols(rank_) * along.cwiseQuotient(values_.head(rank_));
  // A parameter without influence has no length and stays where it is.
  return -(lengths_.array() > 0.0).select(scaled.array() / lengths_.array(), 0.0);
}

Matrix JacobianFactors::inverse_normal() const {
  const Matrix half =
      lengths_.cwiseInverse().asDiagonal() * right_ * values_.cwiseInverse().asDiagonal();
  return half * half.transpose();
}

std::vector<std::vector<Eigen::Index>> JacobianFactors::untold() const {
  // Entries of a unit vector of at most this size are not reported.
  constexpr double kPart = 0.1;
  std::vector<std::vector<Eigen::Index>> directions;
  for (Eigen::Index k = rank_; k < values_.size(); ++k) {
    std::vector<Eigen::Index> parts;
    for (Eigen::Index j = 0; j < right_.rows(); ++j)
      if (std::abs(right_(j, k)) > kPart) parts.push_back(j);
    directions.push_back(parts);
  }
  return directions;
}

}  // namespace graze
