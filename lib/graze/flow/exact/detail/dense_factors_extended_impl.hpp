// Definitions of dense_factors_extended.hpp; included by one translation unit.
#pragma once

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "graze/base/stop_scope.hpp"
#include "graze/flow/exact/detail/dense_factors_extended.hpp"

// A product of two columns of 400 numbers takes some 20 us: every loop over them asks whether its
// time is over, and what it leaves then is of no use to anyone.
namespace graze {
namespace extended_columns {

using ExtendedMatrix = RealMatrix<Extended>;
using ExtendedVector = RealVector<Extended>;

inline Extended column_product(const ExtendedMatrix& a, Eigen::Index i, const ExtendedMatrix& b,
                               Eigen::Index j, Eigen::Index from = 0) {
  Extended sum = 0;
  for (Eigen::Index k = from; k < a.rows(); ++k) sum += a(k, i) * b(k, j);
  return sum;
}

inline void turn(ExtendedMatrix& a, Eigen::Index i, Eigen::Index j, const Extended& cosine,
                 const Extended& sine) {
  for (Eigen::Index k = 0; k < a.rows(); ++k) {
    const Extended first = a(k, i), second = a(k, j);
    a(k, i) = cosine * first - sine * second;
    a(k, j) = sine * first + cosine * second;
  }
}

// Makes two columns orthogonal; false where they were, to rounding.
inline bool part(ExtendedMatrix& a, ExtendedMatrix& v, Eigen::Index i, Eigen::Index j) {
  const Extended p = column_product(a, i, a, i), q = column_product(a, j, a, j);
  const Extended along = column_product(a, i, a, j);
  const Extended rounding =
      Extended(static_cast<int>(a.rows())) * std::numeric_limits<Extended>::epsilon();
  if (along * along <= rounding * rounding * p * q) return false;
  const Extended cotangent = (q - p) / (2 * along);  // of twice the angle
  const Extended tangent =
      (cotangent < 0 ? -1 : 1) / (abs(cotangent) + sqrt(1 + cotangent * cotangent));
  const Extended cosine = 1 / sqrt(1 + tangent * tangent);
  turn(a, i, j, cosine, tangent * cosine);
  turn(v, i, j, cosine, tangent * cosine);
  return true;
}

// x less tau v (v^T x) for the columns `from` on, v_k = 0 above row `row`.
inline void reflect(ExtendedMatrix& a, Eigen::Index from, const ExtendedMatrix& v, Eigen::Index row,
                    const Extended& tau) {
  for (Eigen::Index j = from; j < a.cols() && !StopScope::is_over(); ++j) {
    const Extended along = tau * column_product(v, row, a, j, row);
    for (Eigen::Index k = row; k < a.rows(); ++k) a(k, j) -= along * v(k, row);
  }
}

}  // namespace extended_columns

template <>
RealMatrix<Extended> product(const RealMatrix<Extended>& a, const RealMatrix<Extended>& b) {
  RealMatrix<Extended> c = RealMatrix<Extended>::Zero(a.rows(), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j)
    for (Eigen::Index k = 0; k < b.rows() && !StopScope::is_over(); ++k)
      for (Eigen::Index i = 0; i < a.rows(); ++i) c(i, j) += a(i, k) * b(k, j);
  return c;
}

template <>
RealMatrix<Extended> transposed_product(const RealMatrix<Extended>& a,
                                        const RealMatrix<Extended>& b) {
  RealMatrix<Extended> c(a.cols(), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j)
    for (Eigen::Index i = 0; i < a.cols() && !StopScope::is_over(); ++i)
      c(i, j) = extended_columns::column_product(a, i, b, j);
  return c;
}

template <>
RealVector<Extended> image(const RealMatrix<Extended>& a, const RealVector<Extended>& x) {
  RealVector<Extended> y = RealVector<Extended>::Zero(a.rows());
  for (Eigen::Index k = 0; k < x.size(); ++k)
    for (Eigen::Index i = 0; i < a.rows(); ++i) y[i] += a(i, k) * x[k];
  return y;
}

template <>
RealVector<Extended> transposed_image(const RealMatrix<Extended>& a,
                                      const RealVector<Extended>& x) {
  RealVector<Extended> y = RealVector<Extended>::Zero(a.cols());
  for (Eigen::Index j = 0; j < a.cols(); ++j)
    for (Eigen::Index k = 0; k < x.size(); ++k) y[j] += a(k, j) * x[k];
  return y;
}

void PivotedLu<Extended>::exchange(Index step, Index row, Index column) {
  const Index n = factors_.rows();
  std::swap(rows_[static_cast<std::size_t>(step)], rows_[static_cast<std::size_t>(row)]);
  std::swap(columns_[static_cast<std::size_t>(step)], columns_[static_cast<std::size_t>(column)]);
  for (Index j = 0; j < n && row != step; ++j) std::swap(factors_(step, j), factors_(row, j));
  for (Index i = 0; i < n && column != step; ++i) std::swap(factors_(i, step), factors_(i, column));
}

PivotedLu<Extended>::PivotedLu(const RealMatrix<Extended>& matrix)
    : factors_(matrix),
      rows_(static_cast<std::size_t>(matrix.rows())),
      columns_(static_cast<std::size_t>(matrix.rows())) {
  std::iota(rows_.begin(), rows_.end(), Index{0});
  std::iota(columns_.begin(), columns_.end(), Index{0});
  const Index n = factors_.rows();
  Extended smallest = 0;
  for (Index k = 0; k < n && !StopScope::is_over(); ++k) {
    Index row = k, column = k;
    for (Index j = k; j < n; ++j)
      for (Index i = k; i < n; ++i)
        if (abs(factors_(i, j)) > abs(factors_(row, column))) row = i, column = j;
    const Extended size = abs(factors_(row, column));
    if (k == 0) smallest = size * static_cast<int>(n) * std::numeric_limits<Extended>::epsilon();
    if (!(size > smallest)) return;
    exchange(k, row, column);
    rank_ = k + 1;
    for (Index i = k + 1; i < n; ++i) factors_(i, k) /= factors_(k, k);
    for (Index j = k + 1; j < n && !StopScope::is_over(); ++j)
      for (Index i = k + 1; i < n; ++i) factors_(i, j) -= factors_(i, k) * factors_(k, j);
  }
}

RealVector<Extended> PivotedLu<Extended>::solve(const RealVector<Extended>& right) const {
  const Index n = factors_.rows();
  RealVector<Extended> y(n), x = RealVector<Extended>::Zero(n);
  for (Index i = 0; i < n; ++i) {
    y[i] = right[rows_[static_cast<std::size_t>(i)]];
    for (Index j = 0; j < std::min(i, rank_); ++j) y[i] -= factors_(i, j) * y[j];
  }
  for (Index i = rank_; i-- > 0;) {
    for (Index j = i + 1; j < rank_; ++j) y[i] -= factors_(i, j) * y[j];
    y[i] /= factors_(i, i);
    x[columns_[static_cast<std::size_t>(i)]] = y[i];
  }
  return x;
}

RealMatrix<Extended> PivotedLu<Extended>::inverse() const {
  const Index n = factors_.rows();
  RealMatrix<Extended> all(n, n);
  for (Index j = 0; j < n; ++j) all.col(j) = solve(RealVector<Extended>::Unit(n, j));
  return all;
}

template <>
SingularValues<Extended> singular_values(const RealMatrix<Extended>& matrix) {
  constexpr int kMostSweeps = 60;  // some ten are usual
  const Eigen::Index n = matrix.cols();
  RealMatrix<Extended> a = matrix, v = RealMatrix<Extended>::Identity(n, n);
  bool turned = true;
  for (int sweep = 0; turned && sweep < kMostSweeps; ++sweep) {
    turned = false;
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = i + 1; j < n && !StopScope::is_over(); ++j)
        turned = extended_columns::part(a, v, i, j) || turned;
  }
  RealVector<Extended> sizes(n);
  for (Eigen::Index j = 0; j < n; ++j)
    sizes[j] = sqrt(extended_columns::column_product(a, j, a, j));
  std::vector<Eigen::Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index i, Eigen::Index j) { return sizes[i] > sizes[j]; });
  SingularValues<Extended> all{RealMatrix<Extended>::Zero(a.rows(), n), RealVector<Extended>(n),
                               RealMatrix<Extended>(n, n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::Index at = order[static_cast<std::size_t>(j)];
    all.values[j] = sizes[at];
    for (Eigen::Index k = 0; k < n; ++k) all.right(k, j) = v(k, at);
    if (!(sizes[at] > 0)) continue;
    for (Eigen::Index k = 0; k < a.rows(); ++k) all.left(k, j) = a(k, at) / sizes[at];
  }
  return all;
}

template <>
RealMatrix<Extended> orthonormal_columns(const RealMatrix<Extended>& matrix, Eigen::Index count) {
  const Eigen::Index n = matrix.rows(), k = matrix.cols();
  RealMatrix<Extended> v = matrix;  // becomes the vectors of Householder's reflections
  RealVector<Extended> tau = RealVector<Extended>::Zero(k);
  for (Eigen::Index i = 0; i < k; ++i) {
    const Extended first = v(i, i), size = sqrt(extended_columns::column_product(v, i, v, i, i));
    v(i, i) = 1;
    if (!(size > 0)) continue;
    const Extended left = first < 0 ? size : Extended(-size);
    tau[i] = (left - first) / left;
    for (Eigen::Index l = i + 1; l < n; ++l) v(l, i) /= first - left;
    extended_columns::reflect(v, i + 1, v, i, tau[i]);
  }
  RealMatrix<Extended> all = RealMatrix<Extended>::Identity(n, count);
  for (Eigen::Index i = k; i-- > 0;) extended_columns::reflect(all, 0, v, i, tau[i]);
  return all;
}

}  // namespace graze
