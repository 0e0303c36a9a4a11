// Definitions of dense_factors.hpp; included by one translation unit for each scalar.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/stop_scope.hpp"

namespace graze {
namespace dense_columns {

// Turns columns i and j of a matrix in their plane.
template <class Real>
void turn(RealMatrix<Real>& a, Eigen::Index i, Eigen::Index j, const Real& cosine,
          const Real& sine) {
  for (Eigen::Index k = 0; k < a.rows(); ++k) {
    const Real first = a(k, i), second = a(k, j);
    a(k, i) = cosine * first - sine * second;
    a(k, j) = sine * first + cosine * second;
  }
}

// Columns that are made orthogonal, with the rotations that do it.
template <class Real>
class OrthogonalColumns {
 public:
  // A = columns V^T, V orthogonal.
  OrthogonalColumns(RealMatrix<Real> columns, RealMatrix<Real> v)
      : columns_(std::move(columns)),
        v_(std::move(v)),
        squares_(columns_.colwise().squaredNorm()),
        rounding_(Real(static_cast<int>(columns_.rows())) * std::numeric_limits<Real>::epsilon()) {}

  void sweep_until_orthogonal() {
    constexpr int kMostSweeps = 60;  // some ten are usual
    bool turned = true;
    for (int sweep = 0; turned && sweep < kMostSweeps; ++sweep) {
      turned = false;
      for (Eigen::Index i = 0; i < columns_.cols(); ++i)
        for (Eigen::Index j = i + 1; j < columns_.cols() && !StopScope::is_over(); ++j)
          turned = part(i, j) || turned;
    }
  }

  SingularValues<Real> in_order() const {
    using std::sqrt;
    const Eigen::Index n = columns_.cols();
    std::vector<Eigen::Index> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](Eigen::Index i, Eigen::Index j) { return squares_[i] > squares_[j]; });
    SingularValues<Real> all{RealMatrix<Real>::Zero(columns_.rows(), n), RealVector<Real>(n),
                             RealMatrix<Real>(n, n)};
    for (Eigen::Index j = 0; j < n; ++j) {
      const Eigen::Index at = order[static_cast<std::size_t>(j)];
      all.values[j] = sqrt(squares_[at]);
      all.right.col(j) = v_.col(at);
      if (all.values[j] > 0) all.left.col(j) = columns_.col(at) / all.values[j];
    }
    return all;
  }

 private:
  // Makes two columns orthogonal; false where they were, to rounding.
  bool part(Eigen::Index i, Eigen::Index j) {
    using std::abs, std::sqrt;
    const Real along = columns_.col(i).dot(columns_.col(j));
    if (along * along <= rounding_ * rounding_ * squares_[i] * squares_[j]) return false;
    const Real cotangent = (squares_[j] - squares_[i]) / (2 * along);  // of twice the angle
    const Real size = abs(cotangent) + sqrt(1 + cotangent * cotangent);
    const Real tangent = (cotangent < 0 ? -1 : 1) / size;
    const Real cosine = 1 / sqrt(1 + tangent * tangent), sine = tangent * cosine;
    turn(columns_, i, j, cosine, sine);
    turn(v_, i, j, cosine, sine);
    squares_[i] = columns_.col(i).squaredNorm();
    squares_[j] = columns_.col(j).squaredNorm();
    return true;
  }

  RealMatrix<Real> columns_, v_;
  RealVector<Real> squares_;  // of the columns' lengths
  Real rounding_;
};

template <class Real>
SingularValues<Real> by_rotations(RealMatrix<Real> columns, RealMatrix<Real> v) {
  OrthogonalColumns<Real> orthogonal(std::move(columns), std::move(v));
  orthogonal.sweep_until_orthogonal();
  return orthogonal.in_order();
}

// x less tau v (v^T x) for the columns `from` on, v_k = 0 above row `row`.
template <class Real>
void reflect(RealMatrix<Real>& a, Eigen::Index from, const RealMatrix<Real>& v, Eigen::Index row,
             const Real& tau) {
  for (Eigen::Index j = from; j < a.cols() && !StopScope::is_over(); ++j) {
    Real along = 0;
    for (Eigen::Index k = row; k < a.rows(); ++k) along += v(k, row) * a(k, j);
    along *= tau;
    for (Eigen::Index k = row; k < a.rows(); ++k) a(k, j) -= along * v(k, row);
  }
}

}  // namespace dense_columns

template <class Real>
void PivotedLu<Real>::exchange(Index step, Index row, Index column) {
  const Index n = factors_.rows();
  std::swap(rows_[static_cast<std::size_t>(step)], rows_[static_cast<std::size_t>(row)]);
  std::swap(columns_[static_cast<std::size_t>(step)], columns_[static_cast<std::size_t>(column)]);
  for (Index j = 0; j < n && row != step; ++j) std::swap(factors_(step, j), factors_(row, j));
  for (Index i = 0; i < n && column != step; ++i) std::swap(factors_(i, step), factors_(i, column));
}

template <class Real>
PivotedLu<Real>::PivotedLu(const RealMatrix<Real>& matrix)
    : factors_(matrix),
      rows_(static_cast<std::size_t>(matrix.rows())),
      columns_(static_cast<std::size_t>(matrix.rows())) {
  using std::abs;
  std::iota(rows_.begin(), rows_.end(), Index{0});
  std::iota(columns_.begin(), columns_.end(), Index{0});
  const Index n = factors_.rows();
  Real smallest = 0;
  for (Index k = 0; k < n && !StopScope::is_over(); ++k) {
    Index row = k, column = k;
    Real size = 0;
    for (Index j = k; j < n; ++j)
      for (Index i = k; i < n; ++i)
        if (const Real here = abs(factors_(i, j)); here > size) size = here, row = i, column = j;
    if (k == 0) smallest = size * static_cast<int>(n) * std::numeric_limits<Real>::epsilon();
    if (!(size > smallest)) return;
    exchange(k, row, column);
    rank_ = k + 1;
    for (Index i = k + 1; i < n; ++i) factors_(i, k) /= factors_(k, k);
    for (Index j = k + 1; j < n && !StopScope::is_over(); ++j)
      for (Index i = k + 1; i < n; ++i) factors_(i, j) -= factors_(i, k) * factors_(k, j);
  }
}

template <class Real>
RealVector<Real> PivotedLu<Real>::solve(const RealVector<Real>& right) const {
  const Index n = factors_.rows();
  RealVector<Real> y(n), x = RealVector<Real>::Zero(n);
  for (Index i = 0; i < n; ++i) y[i] = right[rows_[static_cast<std::size_t>(i)]];
  for (Index j = 0; j < rank_; ++j)
    for (Index i = j + 1; i < n; ++i) y[i] -= factors_(i, j) * y[j];
  for (Index j = rank_; j-- > 0;) {
    y[j] /= factors_(j, j);
    for (Index i = 0; i < j; ++i) y[i] -= factors_(i, j) * y[j];
    x[columns_[static_cast<std::size_t>(j)]] = y[j];
  }
  return x;
}

template <class Real>
RealMatrix<Real> PivotedLu<Real>::inverse() const {
  const Index n = factors_.rows();
  RealMatrix<Real> all(n, n);
  for (Index j = 0; j < n; ++j) all.col(j) = solve(RealVector<Real>::Unit(n, j));
  return all;
}

template <class Real>
SingularValues<Real> singular_values(const RealMatrix<Real>& matrix) {
  return dense_columns::by_rotations<Real>(
      matrix, RealMatrix<Real>::Identity(matrix.cols(), matrix.cols()));
}

template <class Real>
RealMatrix<Real> orthonormal_columns(const RealMatrix<Real>& matrix, Eigen::Index count) {
  using std::sqrt;
  const Eigen::Index n = matrix.rows(), k = std::min(n, matrix.cols());
  RealMatrix<Real> v = matrix;  // becomes the vectors of Householder's reflections
  RealVector<Real> tau = RealVector<Real>::Zero(k);
  for (Eigen::Index i = 0; i < k; ++i) {
    const Real first = v(i, i), below = v.col(i).tail(n - i - 1).squaredNorm();
    v(i, i) = 1;
    if (!(below > 0)) continue;
    const Real size = sqrt(first * first + below), left = first < 0 ? size : Real(-size);
    tau[i] = (left - first) / left;
    for (Eigen::Index l = i + 1; l < n; ++l) v(l, i) /= first - left;
    dense_columns::reflect(v, i + 1, v, i, tau[i]);
  }
  RealMatrix<Real> all = RealMatrix<Real>::Identity(n, count);
  for (Eigen::Index i = k; i-- > 0;) dense_columns::reflect(all, 0, v, i, tau[i]);
  return all;
}

}  // namespace graze
