#include "graze/continuation/branch/detail/bordering.hpp"

#include <cmath>

namespace graze {
namespace {

// Each solution with the borders of the previous one is a step of inverse iteration; the smallest
// singular value is far below the others, so a few steps suffice for its vectors.
constexpr int kInverseIterations = 4;

template <class Square>
Square bordered(const Square& matrix, const Borders& borders) {
  using Scalar = typename Square::Scalar;
  const Eigen::Index n = matrix.rows();
  Square whole = Square::Zero(n + 1, n + 1);
  whole.topLeftCorner(n, n) = matrix;
  whole.col(n).head(n) = (borders.scale * borders.left).template cast<Scalar>();
  whole.row(n).head(n) = (borders.scale * borders.right).transpose().template cast<Scalar>();
  return whole;
}

template <class Column>
Column extended(const Column& head, const typename Column::Scalar& last) {
  Column whole(head.size() + 1);
  whole << head, last;
  return whole;
}

Vector direction_of(const Vector& vector) { return vector.normalized(); }

// Multiplied by the phase factor that makes sum v_k^2 positive; real and imaginary part are then
// orthogonal and the real one is the longer.
Vector direction_of(const ComplexVector& vector) {
  const Complex square = vector.cwiseProduct(vector).sum();
  return (std::polar(1.0, -0.5 * std::arg(square)) * vector).real().normalized();
}

// A vector unlikely to be orthogonal to one from equations: entries between 1/2 and 3/2, spread by
// multiples of the golden ratio.
Vector irregular(Eigen::Index n) {
  Vector vector(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double multiple = 0.6180339887498949 * static_cast<double>(k + 1);
    vector[k] = 0.5 + multiple - std::floor(multiple);
  }
  return vector.normalized();
}

}  // namespace

template <class Scalar>
BorderedMatrix<Scalar>::BorderedMatrix(const Square& matrix, const Borders& borders)
    : factors_(bordered(matrix, borders)), scale_(borders.scale) {
  const Eigen::Index n = matrix.rows();
  const Column target = extended<Column>(Column::Zero(n), Scalar(scale_));
  const Column solution = factors_.solve(target);
  right_ = solution.head(n);
  test_ = solution[n];
  left_ = factors_.solve_transposed(target).head(n);
}

template <class Scalar>
typename BorderedMatrix<Scalar>::Column BorderedMatrix<Scalar>::solve(const Column& r) const {
  return factors_.solve(extended<Column>(r, Scalar(0.0))).head(r.size());
}

template <class Scalar>
typename BorderedMatrix<Scalar>::Column BorderedMatrix<Scalar>::solve_transposed(
    const Column& r) const {
  return factors_.solve_transposed(extended<Column>(r, Scalar(0.0))).head(r.size());
}

template <class Scalar>
Borders BorderedMatrix<Scalar>::renewed(double scale) const {
  return {direction_of(left_), direction_of(right_), scale};
}

template <class Scalar>
Borders first_borders(const typename BorderedMatrix<Scalar>::Square& matrix, double scale) {
  const Vector start = irregular(matrix.rows());
  Borders borders{start, start, scale};
  for (int i = 0; i < kInverseIterations; ++i) {
    const BorderedMatrix<Scalar> at(matrix, borders);
    if (!at.finite()) break;
    borders = at.renewed(borders.scale);
  }
  return borders;
}

template class BorderedMatrix<double>;
template class BorderedMatrix<Complex>;
template Borders first_borders<double>(const Matrix&, double);
template Borders first_borders<Complex>(const Eigen::MatrixXcd&, double);

}  // namespace graze
