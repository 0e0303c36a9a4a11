#include <Eigen/Jacobi>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "graze/base/linalg/detail/arithmetic.hpp"
#include "graze/base/linalg/detail/dense_factors.hpp"

namespace graze {
namespace {

using Eigen::Index;
using Column = Eigen::Map<Vector>;

constexpr int kSweepsPerValue = 30;  // per value; some 2 are usual

// Rows `from` on of a column.
Column part(Matrix& matrix, Index column, Index from) {
  return {matrix.col(column).data() + from, matrix.rows() - from};
}

// The reflection I - tau v v^T, v_0 = 1, that leaves of x its first entry: v becomes x, the entry
// is returned.
double reflect(Column x, double& tau) {
  const double first = x[0], rest = x.tail(x.size() - 1).norm();
  tau = 0.0;
  if (rest == 0.0) {
    x[0] = 1.0;
    return first;
  }
  const double left = -std::copysign(std::hypot(first, rest), first);
  tau = (left - first) / left;
  x /= first - left;
  x[0] = 1.0;
  return left;
}

// A = U B V^T with B of two diagonals (Householder; G. Golub, W. Kahan, SIAM J. Numer. Anal. B 2
// (1965) 205-224), then B's singular values by sweeps with and without shifts (J. Demmel, W. Kahan,
// SIAM J. Sci. Stat. Comput. 11 (1990) 873-912), which only V is told of.
class GolubKahan {
 public:
  explicit GolubKahan(const Matrix& matrix)
      : n_(matrix.cols()), diagonal_(n_), above_(Vector::Zero(n_)), v_(Matrix::Identity(n_, n_)) {
    reduce(matrix);
  }

  // False where it does not converge.
  bool iterate();
  SingularValues<double> sorted() const;

 private:
  void reduce(Matrix a);
  void form_vectors(Matrix& reflections, const Vector& taus);
  double shift(Index first, Index last) const;
  void sweep(Index first, Index last, double shift);
  void sweep_without_shift(Index first, Index last);
  Eigen::JacobiRotation<double> turned(double f, double g, double& length) const;
  void turn_vectors(Index i, const Eigen::JacobiRotation<double>& rotation) {
    v_.applyOnTheRight(i, i + 1, rotation);
  }

  Index n_;
  Vector diagonal_, above_;  // above_[i] beside diagonal_[i]; the last is 0
  Matrix v_;
};

void GolubKahan::reduce(Matrix a) {
  Matrix rows = Matrix::Zero(n_, n_);  // column k: the reflection of row k, from entry k + 1 on
  Vector taus = Vector::Zero(n_), along(a.rows());
  for (Index k = 0; k < n_; ++k) {
    double tau = 0.0;
    const Column v = part(a, k, k);
    diagonal_[k] = reflect(v, tau);
    for (Index j = k + 1; j < n_; ++j) {
      Column x = part(a, j, k);
      x -= (tau * v.dot(x)) * v;
    }
    if (k + 1 == n_) break;
    Column w = part(rows, k, k + 1);
    w = a.row(k).tail(n_ - k - 1);
    above_[k] = reflect(w, taus[k]);
    Column sum(along.data(), a.rows() - k - 1);
    sum.setZero();
    for (Index j = k + 1; j < n_; ++j) sum += w[j - k - 1] * part(a, j, k + 1);
    for (Index j = k + 1; j < n_; ++j) part(a, j, k + 1) -= (taus[k] * w[j - k - 1]) * sum;
  }
  form_vectors(rows, taus);
}

// The product of the reflections, last to first, so that each meets only what those after it fill.
void GolubKahan::form_vectors(Matrix& reflections, const Vector& taus) {
  for (Index k = n_ - 2; k >= 0; --k) {
    const Column w = part(reflections, k, k + 1);
    for (Index j = k + 1; j < n_; ++j) {
      Column x = part(v_, j, k + 1);
      x -= (taus[k] * w.dot(x)) * w;
    }
  }
}

// (f, g) becomes (length, 0).
Eigen::JacobiRotation<double> GolubKahan::turned(double f, double g, double& length) const {
  length = std::hypot(f, g);
  if (length == 0.0) return {1.0, 0.0};
  return {f / length, -g / length};
}

// The smaller singular value of the last two rows and columns; 0 where it would be lost beside the
// first diagonal entry.
double GolubKahan::shift(Index first, Index last) const {
  const double a = diagonal_[last - 1], b = above_[last - 1], c = diagonal_[last];
  const double sum = std::hypot(a + c, b), difference = std::hypot(a - c, b);
  const double larger = 0.5 * (sum + difference);
  const double smaller = larger > 0.0 ? std::abs(a) / larger * std::abs(c) : 0.0;
  const double beside = smaller / std::abs(diagonal_[first]);
  return beside * beside >= kEpsilon && std::isfinite(beside) ? smaller : 0.0;
}

void GolubKahan::sweep(Index first, Index last, double shift) {
  Vector &d = diagonal_, &e = above_;
  double f = (std::abs(d[first]) - shift) * (std::copysign(1.0, d[first]) + shift / d[first]);
  double g = e[first], length = 0.0;
  for (Index i = first; i < last; ++i) {
    const Eigen::JacobiRotation<double> right = turned(f, g, length);
    if (i > first) e[i - 1] = length;
    f = right.c() * d[i] - right.s() * e[i];
    e[i] = right.c() * e[i] + right.s() * d[i];
    g = -right.s() * d[i + 1];
    d[i + 1] *= right.c();
    turn_vectors(i, right);
    const Eigen::JacobiRotation<double> left = turned(f, g, d[i]);
    f = left.c() * e[i] - left.s() * d[i + 1];
    d[i + 1] = left.c() * d[i + 1] + left.s() * e[i];
    if (i + 1 == last) break;
    g = -left.s() * e[i + 1];
    e[i + 1] *= left.c();
  }
  e[last - 1] = f;
}

void GolubKahan::sweep_without_shift(Index first, Index last) {
  Vector &d = diagonal_, &e = above_;
  Eigen::JacobiRotation<double> right(1.0, 0.0), left(1.0, 0.0);
  double length = 0.0;
  for (Index i = first; i < last; ++i) {
    right = turned(d[i] * right.c(), e[i], length);
    if (i > first) e[i - 1] = -left.s() * length;
    left = turned(left.c() * length, -d[i + 1] * right.s(), d[i]);
    turn_vectors(i, right);
  }
  const double end = d[last] * right.c();
  d[last] = end * left.c();
  e[last - 1] = -end * left.s();
}

bool GolubKahan::iterate() {
  Index last = n_ - 1;
  for (Index sweeps = 0; last > 0; ++sweeps) {
    Index first = last;
    while (first > 0) {
      double& beside = above_[first - 1];
      if (std::abs(beside) <=
          kEpsilon * (std::abs(diagonal_[first - 1]) + std::abs(diagonal_[first])))
        beside = 0.0;
      if (beside == 0.0) break;
      --first;
    }
    if (first == last) {
      --last;
      continue;
    }
    if (sweeps > kSweepsPerValue * n_) return false;
    const double chosen = shift(first, last);
    if (chosen > 0.0)
      sweep(first, last, chosen);
    else
      sweep_without_shift(first, last);
  }
  return diagonal_.allFinite();
}

SingularValues<double> GolubKahan::sorted() const {
  std::vector<Index> order(static_cast<std::size_t>(n_));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [this](Index a, Index b) {
    return std::abs(diagonal_[a]) > std::abs(diagonal_[b]);
  });
  SingularValues<double> all{{}, Vector(n_), Matrix(n_, n_)};
  for (Index j = 0; j < n_; ++j) {
    const Index at = order[static_cast<std::size_t>(j)];
    all.values[j] = std::abs(diagonal_[at]);
    all.right.col(j) = std::copysign(1.0, diagonal_[at]) * v_.col(at);
  }
  return all;
}

}  // namespace

SingularValues<double> right_singular_vectors(const RealMatrix<double>& matrix) {
  // Jacobi's method takes a few milliseconds for that many.
  constexpr Eigen::Index kSmall = 64;
  if (matrix.cols() > kSmall) {
    GolubKahan large(matrix);
    if (large.iterate()) return large.sorted();
  }
  SingularValues<double> all = singular_values<double>(matrix);
  return {{}, all.values, all.right};
}

}  // namespace graze
