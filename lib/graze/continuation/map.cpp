#include "graze/continuation/map.hpp"

#include <utility>

#include "graze/base/linalg/detail/product_eigenvalues.hpp"

namespace graze {
namespace {

std::optional<ZeroEvaluation> evaluate(const Map& map, int period, const Vector& u, Parameters at) {
  const Eigen::Index size = u.size(), n = size / period, last = size - n;
  ZeroEvaluation sum{Vector(size), Matrix::Zero(size, size),
                     Matrix(size, static_cast<Eigen::Index>(at.size())), Matrix::Zero(size, size)};
  sum.closing.block(last, 0, n, n) = -Matrix::Identity(n, n);
  for (Eigen::Index i = 0; i < size; i += n) {
    const Eigen::Index next = (i + n) % size;
    const std::optional<MapEvaluation> f = map.evaluate(u.segment(i, n), at);
    if (!f) return {};
    sum.residual.segment(i, n) = f->image - u.segment(next, n);
    sum.jacobian.block(i, i, n, n) += f->jacobian;
    sum.jacobian.block(i, next, n, n) -= Matrix::Identity(n, n);
    sum.by_parameters.middleRows(i, n) = f->by_parameters;
  }
  return sum;
}

// The map's curvature with complex vectors, from their real and imaginary parts.
std::optional<ComplexVector> complex_curvature(const Map& map, const Vector& x, Parameters at,
                                               const ComplexVector& left,
                                               const ComplexVector& right) {
  ComplexVector sum = ComplexVector::Zero(x.size() + static_cast<Eigen::Index>(at.size()));
  const auto add = [&](const Vector& w, const Vector& v, const Complex& factor) {
    if (w.isZero(0.0) || v.isZero(0.0)) return true;
    const std::optional<Vector> part = map.curvature(x, at, w, v);
    if (part) sum += factor * part->cast<Complex>();
    return part.has_value();
  };
  const Complex i(0.0, 1.0);
  if (!add(left.real(), right.real(), 1.0) || !add(left.imag(), right.real(), i) ||
      !add(left.real(), right.imag(), i) || !add(left.imag(), right.imag(), -1.0))
    return {};
  return sum;
}

// The closing is constant, so no product depends on its multiplier.
std::optional<Eigen::MatrixXcd> curvature(const Map& map, int period, const Vector& u,
                                          Parameters at,
                                          const std::vector<CriticalProduct>& products) {
  const Eigen::Index size = u.size(), n = size / period, m = static_cast<Eigen::Index>(at.size());
  Eigen::MatrixXcd rows =
      Eigen::MatrixXcd::Zero(static_cast<Eigen::Index>(products.size()), size + m);
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    const CriticalProduct& product = products[static_cast<std::size_t>(row)];
    for (Eigen::Index i = 0; i < size; i += n) {
      const std::optional<ComplexVector> part = complex_curvature(
          map, u.segment(i, n), at, product.left.segment(i, n), product.right.segment(i, n));
      if (!part) return {};
      rows.row(row).segment(i, n) += part->head(n).transpose();
      rows.row(row).tail(m) += part->tail(m).transpose();
    }
  }
  return rows;
}

std::vector<Eigenvalue> multipliers(const Map& map, int period, const Vector& u, Parameters at,
                                    ErrorBounds errors) {
  const Eigen::Index n = u.size() / period;
  std::vector<Matrix> factors;
  for (Eigen::Index i = 0; i < u.size(); i += n) {
    const std::optional<MapEvaluation> f = map.evaluate(u.segment(i, n), at);
    if (!f) return {};
    factors.push_back(f->jacobian);
  }
  return product_eigenvalues(factors, errors);
}

}  // namespace

ZeroProblem periodic_points(const Map& map, int period) {
  ZeroProblem problem;
  problem.evaluate = [map, period](const Vector& u, Parameters at) {
    return evaluate(map, period, u, at);
  };
  problem.multipliers = [map, period](const Vector& u, Parameters at, ErrorBounds errors) {
    return multipliers(map, period, u, at, errors);
  };
  if (map.curvature)
    problem.curvature = [map, period](const Vector& u, Parameters at,
                                      const std::vector<CriticalProduct>& products) {
      return curvature(map, period, u, at, products);
    };
  return problem;
}

SolutionPoint twice_round(const SolutionPoint& point) {
  const Eigen::Index n = point.u.size();
  SolutionPoint twice = point;
  twice.multipliers.clear();
  twice.orientation = 0;
  twice.u.resize(2 * n);
  twice.u << point.u, point.u;
  twice.tangent.resize(2 * n + 1);
  twice.tangent << point.tangent.head(n), point.tangent.head(n), point.tangent[n];
  twice.tangent.normalize();
  return twice;
}

}  // namespace graze
