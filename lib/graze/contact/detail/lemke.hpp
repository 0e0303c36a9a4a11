// Lemke's method for the linear complementarity problem
//
//   w = M z + q >= 0,   z >= 0,   z.w = 0,
//
// by a path of pivots from z = 0: a covering variable makes w feasible, and each pivot brings the
// complement of the one that left, until the covering variable leaves. Ends at a solution for every
// positive semidefinite M that has one, and for every M whose principal minors are all positive; a
// path that ends on a ray shows for these that there is none. Ratios are compared in lexicographic
// order, so that no basis comes twice however many of them tie (R. W. Cottle, J.-S. Pang, R. E.
// Stone, The Linear Complementarity Problem, 1992, 4.4).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "graze/base/vector.hpp"

namespace graze {

// The path of a positive definite matrix is usually as long as its size; the search ends without a
// solution when it takes this many times more.
inline constexpr int kMostPivotsPerRow = 50;

template <class Real>
class LemkeTableau {
 public:
  LemkeTableau(const RealMatrix<Real>& m, const RealVector<Real>& q)
      : size_(q.size()), table_(size_, 2 * size_ + 2), basis_(static_cast<std::size_t>(size_)) {
    // I w - M z - e z0 = q; columns w, z, z0, right-hand side.
    table_.leftCols(size_).setIdentity();
    table_.middleCols(size_, size_) = -m;
    table_.col(cover()).setConstant(Real(-1));
    table_.col(cover() + 1) = q;
    for (Eigen::Index i = 0; i < size_; ++i) basis_[static_cast<std::size_t>(i)] = i;
    tiny_ = Real(static_cast<int>(size_) + 8) * std::numeric_limits<Real>::epsilon();
  }

  // The indices of z that are basic at the end, or nullopt when the path ends on a ray.
  std::optional<std::vector<Eigen::Index>> solve() {
    if (!(right().minCoeff() < 0)) return acting();
    Eigen::Index row = most_violated();
    Eigen::Index entering = complement(replace(row, cover()));
    for (Eigen::Index i = 0; i < kMostPivotsPerRow * (size_ + 1); ++i) {
      row = leaving_row(entering);
      if (row < 0) return {};
      const Eigen::Index left = replace(row, entering);
      if (left == cover()) return acting();
      entering = complement(left);
    }
    return {};
  }

 private:
  Eigen::Index cover() const { return 2 * size_; }
  auto right() const { return table_.col(cover() + 1); }
  Eigen::Index complement(Eigen::Index variable) const {
    return variable < size_ ? variable + size_ : variable - size_;
  }

  std::vector<Eigen::Index> acting() const {
    std::vector<Eigen::Index> list;
    for (const Eigen::Index variable : basis_)
      if (variable >= size_ && variable < cover()) list.push_back(variable - size_);
    return list;
  }

  // The covering variable enters where q is smallest; of equal ones the last row, which is the
  // lexicographically smallest of (q, I).
  Eigen::Index most_violated() const {
    Eigen::Index row = 0;
    for (Eigen::Index i = 1; i < size_; ++i)
      if (!(right()[row] < right()[i])) row = i;
    return row;
  }

  // Whether row a of (right, inverse of the basis)/pivot comes before row b.
  bool precedes(Eigen::Index a, Eigen::Index b, Eigen::Index entering) const {
    using std::abs, std::max;
    const Real pa = table_(a, entering), pb = table_(b, entering);
    const auto compare = [&](Eigen::Index column) {
      const Real x = table_(a, column) / pa, y = table_(b, column) / pb;
      if (abs(x - y) <= tiny_ * max(abs(x), abs(y))) return 0;
      return x < y ? -1 : 1;
    };
    if (const int order = compare(cover() + 1); order != 0) return order < 0;
    for (Eigen::Index column = 0; column < size_; ++column)
      if (const int order = compare(column); order != 0) return order < 0;
    return false;
  }

  // Found by the least ratio; the covering variable leaves as soon as it can. -1: no row limits it.
  Eigen::Index leaving_row(Eigen::Index entering) const {
    using std::abs;
    const Real least = tiny_ * table_.col(entering).cwiseAbs().maxCoeff();
    Eigen::Index row = -1;
    for (Eigen::Index i = 0; i < size_; ++i)
      if (table_(i, entering) > least && (row < 0 || precedes(i, row, entering))) row = i;
    if (row < 0) return row;
    const Real ratio = right()[row] / table_(row, entering);
    for (Eigen::Index i = 0; i < size_; ++i) {
      if (basis_[static_cast<std::size_t>(i)] != cover() || !(table_(i, entering) > least))
        continue;
      if (right()[i] / table_(i, entering) <= ratio + tiny_ * abs(ratio)) return i;
    }
    return row;
  }

  // Pivots; returns the variable that leaves the basis.
  Eigen::Index replace(Eigen::Index row, Eigen::Index entering) {
    table_.row(row) /= Real(table_(row, entering));
    for (Eigen::Index i = 0; i < size_; ++i) {
      const Real factor = table_(i, entering);
      if (i == row || factor == 0) continue;
      table_.row(i) -= factor * table_.row(row);
      table_(i, entering) = 0;
    }
    return std::exchange(basis_[static_cast<std::size_t>(row)], entering);
  }

  Eigen::Index size_;
  RealMatrix<Real> table_;
  std::vector<Eigen::Index> basis_;  // the variable of each row
  Real tiny_;                        // ratios closer than this part of them are equal
};

}  // namespace graze
