#include "graze/base/linalg/detail/periodic_hessenberg.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "graze/base/linalg/detail/arithmetic.hpp"
#include "graze/base/linalg/detail/products.hpp"

namespace graze {
namespace {

constexpr int kMaxSteps = 120;  // per eigenvalue or pair; some 2 are usual

// A matrix times 2^exponent, its largest entry between 1/2 and 1, or zero.
struct ScaledBlock {
  Eigen::Matrix3d matrix;
  long exponent = 0;

  void normalise() {
    int shift = 0;
    const double size = matrix.cwiseAbs().maxCoeff();
    if (!(size > 0.0)) return;
    std::frexp(size, &shift);
    matrix *= std::ldexp(1.0, -shift);
    exponent += shift;
  }
  // As a multiple of 2^unit.
  Eigen::Matrix3d in(long unit) const {
    return matrix * std::ldexp(1.0, static_cast<int>(std::max(exponent - unit, -2000L)));
  }
};

// The 3 x 3 diagonal block at `row` of the product of all triangular factors.
ScaledBlock triangular_block(const std::vector<Matrix>& factors, Eigen::Index row) {
  ScaledBlock product{factors[1].block<3, 3>(row, row), 0};
  product.normalise();
  for (std::size_t i = 2; i < factors.size(); ++i) {
    product.matrix = (factors[i].block<3, 3>(row, row) * product.matrix).eval();
    product.normalise();
  }
  return product;
}

// Rows and columns scaled to largest entries of 1, columns last.
Matrix equilibrated(Matrix matrix) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const double size = matrix.row(i).cwiseAbs().maxCoeff();
    if (size > 0.0) matrix.row(i) /= size;
  }
  for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
    const double size = matrix.col(j).cwiseAbs().maxCoeff();
    if (size > 0.0) matrix.col(j) /= size;
  }
  return matrix;
}

// Diagonal entries of R in the QR factorisation with pivoting that its own rounding, n eps of a
// column, does not explain.
Eigen::Index rank_of(const Eigen::ColPivHouseholderQR<Matrix>& qr) {
  const Eigen::Index n = qr.cols();
  Eigen::Index rank = 0;
  const double rounding = static_cast<double>(n) * kEpsilon * qr.maxPivot();
  while (rank < n && std::abs(qr.matrixR()(rank, rank)) > rounding) ++rank;
  return rank;
}

}  // namespace

PeriodicHessenberg::PeriodicHessenberg(std::vector<Matrix> factors)
    : factors_(std::move(factors)),
      n_(factors_.front().rows()),
      active_(n_),
      reflector_(n_),
      projection_(n_) {}

bool PeriodicHessenberg::reduce() {
  split_off_zeros();
  return to_hessenberg() && iterate();
}

// A change of basis in the image of factor `image`, by the reflection that maps rows first ..
// first + size - 1 of its column `column` to a multiple of the first of them. The columns before
// are zero there; of the next factor `rows` rows may be nonzero in the columns concerned.
void PeriodicHessenberg::reflect(std::size_t image, Index first, Index size, Index column,
                                 Index rows) {
  Matrix& left = factors_[image];
  double tau = 0.0, beta = 0.0;
  auto essential = reflector_.segment(1, size - 1);
  left.col(column).segment(first, size).makeHouseholder(essential, tau, beta);
  left(first, column) = beta;
  left.col(column).segment(first + 1, size - 1).setZero();
  if (tau == 0.0) return;
  reflector_[0] = 1.0;
  const double* v = reflector_.data();
  for (Index j = column + 1; j < n_; ++j) {
    double* x = left.col(j).data() + first;
    double dot = 0.0;
    for (Index m = 0; m < size; ++m) dot += v[m] * x[m];
    for (Index m = 0; m < size; ++m) x[m] -= tau * dot * v[m];
  }
  Matrix& right = factors_[next(image)];
  double* dots = projection_.data();
  for (Index i = 0; i < rows; ++i) dots[i] = 0.0;
  for (Index m = 0; m < size; ++m) {
    const double* x = right.col(first + m).data();
    for (Index i = 0; i < rows; ++i) dots[i] += v[m] * x[i];
  }
  for (Index m = 0; m < size; ++m) {
    double* x = right.col(first + m).data();
    for (Index i = 0; i < rows; ++i) x[i] -= tau * v[m] * dots[i];
  }
}

void PeriodicHessenberg::split_off_zeros() {
  for (std::size_t i = 0; i < factors_.size() && active_ > 0;) i = split_off(i) ? 0 : i + 1;
}

// Where the active block of a factor is singular: in a basis that starts with its range its last
// rows are zero. Carried once around the cycle as QR factors, this basis makes every factor block
// upper triangular, and the leading blocks hold the other eigenvalues.
bool PeriodicHessenberg::split_off(std::size_t factor) {
  const Index w = active_;
  const Matrix block = factors_[factor].topLeftCorner(w, w);
  const Index rank = rank_of(Eigen::ColPivHouseholderQR<Matrix>(equilibrated(block)));
  if (rank == w) return false;
  std::rotate(factors_.begin(), factors_.begin() + static_cast<std::ptrdiff_t>(factor),
              factors_.end());
  // Columns of one size, so that a small one counts as much as a large one.
  Matrix columns = block;
  for (Index j = 0; j < w; ++j) {
    const double size = columns.col(j).cwiseAbs().maxCoeff();
    if (size > 0.0) columns.col(j) /= size;
  }
  const Matrix basis = Eigen::ColPivHouseholderQR<Matrix>(columns).householderQ();
  factors_[0].topRows(w) = transposed_product<double>(basis, factors_[0].topRows(w));
  factors_[0].block(rank, 0, w - rank, w).setZero();
  factors_[1].topLeftCorner(w, w) = product<double>(factors_[1].topLeftCorner(w, w), basis);
  for (std::size_t i = 1; i < factors_.size(); ++i)
    for (Index j = 0; j + 1 < w; ++j) reflect(i, j, w - j, j, w);
  active_ = rank;
  return true;
}

bool PeriodicHessenberg::to_hessenberg() {
  const Index w = active_;
  for (Index j = 0; j + 1 < w; ++j) {
    if (StopScope::is_over()) return false;
    for (std::size_t i = 1; i < factors_.size(); ++i) reflect(i, j, w - j, j, w);
    if (j + 2 < w) reflect(0, j + 1, w - j - 1, j, w);
  }
  return true;
}

// First row of the unreduced block of the Hessenberg factor that ends with row `last`. An entry
// below the diagonal within the rounding of its neighbours is none.
PeriodicHessenberg::Index PeriodicHessenberg::window_start(Index last) {
  Matrix& h = factors_[0];
  Index first = last;
  while (first > 0) {
    double size = std::abs(h(first, first)) + std::abs(h(first - 1, first - 1));
    if (size == 0.0) size = h.topLeftCorner(last + 1, last + 1).cwiseAbs().maxCoeff();
    if (std::abs(h(first, first - 1)) <= kEpsilon * size) {
      h(first, first - 1) = 0.0;
      break;
    }
    --first;
  }
  return first;
}

bool PeriodicHessenberg::iterate() {
  Index last = active_ - 1;
  int steps = 0;
  while (last >= 0) {
    const Index first = window_start(last);
    if (last - first < 2) {
      if (last > first) blocks_.push_back(first);
      last = first - 1;
      steps = 0;
      continue;
    }
    if (++steps > kMaxSteps || StopScope::is_over()) return false;
    // Now and then a step from anywhere, in case the shifts go round in circles. Towards a
    // triple defective eigenvalue they gain two bits each, and want no interruption.
    step(first, last,
         steps % 40 == 0 ? Eigen::Vector3d(1.0, 0.75, 0.5) : double_shift(first, last));
  }
  return true;
}

// First column of (M - s1)(M - s2), up to a factor, of the block first .. last of the product
// M = (Hessenberg) (triangular factors); s1 and s2 are the eigenvalues of its last 2 x 2 block.
Eigen::Vector3d PeriodicHessenberg::double_shift(Index first, Index last) const {
  const Matrix& h = factors_[0];
  ScaledBlock head = triangular_block(factors_, first), tail = triangular_block(factors_, last - 2);
  const Eigen::Matrix3d r = head.matrix;
  head.matrix = (h.block<3, 2>(first, first) * head.matrix.topRows<2>()).eval();
  tail.matrix.bottomRows<2>() = (h.block<2, 3>(last - 1, last - 2) * tail.matrix).eval();
  tail.matrix.row(0).setZero();
  head.normalise();
  tail.normalise();
  const long unit = std::max(head.exponent, tail.exponent);
  const Eigen::Matrix3d m = head.in(unit), s = tail.in(unit);
  double trace = s(1, 1) + s(2, 2), determinant = s(1, 1) * s(2, 2) - s(1, 2) * s(2, 1);
  const double half = 0.5 * (s(1, 1) - s(2, 2)), square = half * half + s(1, 2) * s(2, 1);
  if (square >= 0.0) {
    const double root = half > 0.0 ? -std::sqrt(square) : std::sqrt(square);
    const double nearest = 0.5 * trace + root;
    trace = 2.0 * nearest;
    determinant = nearest * nearest;
  }
  // With its first column negligible the triangular product hides an eigenvalue far smaller than
  // the others, and shifts would leave it where it is; a step without them moves it to the end.
  const bool hidden =
      std::abs(r(0, 0)) <= kEpsilon * std::max(std::abs(r(0, 1)), std::abs(r(1, 1))) &&
      std::abs(m(1, 0)) <= kEpsilon * (std::abs(m(0, 0)) + std::abs(m(1, 1)));
  if (hidden) trace = determinant = 0.0;
  const Eigen::Vector3d start((m(0, 0) * (m(0, 0) - trace) + determinant) / m(1, 0) + m(0, 1),
                              m(0, 0) + m(1, 1) - trace, m(2, 1));
  const double size = start.cwiseAbs().maxCoeff();
  if (!(size > 0.0) || !std::isfinite(size)) return {1.0, 0.75, 0.5};
  return start / size;
}

// Makes rows row .. row + size - 1 of the triangular factors, filled by a change of the basis in
// the image of the Hessenberg factor, triangular again, one factor after the other.
void PeriodicHessenberg::triangularise_bulge(Index row, Index size, Index last) {
  for (std::size_t i = 1; i < factors_.size(); ++i) {
    const Index rows = next(i) == 0 ? std::min(row + size, last) + 1 : row + size;
    for (Index j = 0; j + 1 < size; ++j) reflect(i, row + j, size - j, row + j, rows);
  }
}

void PeriodicHessenberg::step(Index first, Index last, const Eigen::Vector3d& start) {
  // The first reflection is that of `start`, the others chase the bulge that it makes to the end.
  Matrix& h = factors_[0];
  for (Index row = first; row < last; ++row) {
    const Index size = std::min<Index>(3, last - row + 1);
    if (row == first) {
      double tau = 0.0, beta = 0.0;
      Eigen::Vector2d essential;
      start.makeHouseholder(essential, tau, beta);
      const Eigen::Vector3d v(1.0, essential[0], essential[1]);
      auto left = h.block(row, row, 3, n_ - row);
      left -= (tau * v * (v.transpose() * left)).eval();
      auto right = factors_[1].block(0, row, row + 3, 3);
      right -= (tau * (right * v) * v.transpose()).eval();
    } else {
      reflect(0, row, size, row - 1, row + size);
    }
    triangularise_bulge(row, size, last);
  }
}

}  // namespace graze
