#include "graze/continuation/plane_map.hpp"

#include <utility>

#include "graze/base/product_eigenvalues.hpp"

namespace graze {
namespace {

std::optional<PlaneEvaluation> evaluate(const PlaneMap& map, int period, const Vector& u, double p,
                                        double q) {
  const Eigen::Index size = u.size(), n = size / period, last = size - n;
  PlaneEvaluation at{Vector(size), Matrix::Zero(size, size), Matrix::Zero(size, size), Vector(size),
                     Vector(size)};
  at.closing.block(last, 0, n, n) = -Matrix::Identity(n, n);
  for (Eigen::Index i = 0; i < size; i += n) {
    const Eigen::Index next = (i + n) % size;
    const std::optional<PlaneMapEvaluation> f = map.evaluate(u.segment(i, n), p, q);
    if (!f) return {};
    at.residual.segment(i, n) = f->image - u.segment(next, n);
    at.jacobian.block(i, i, n, n) = f->jacobian;
    if (i != last) at.jacobian.block(i, next, n, n) = -Matrix::Identity(n, n);
    at.by_first.segment(i, n) = f->by_first;
    at.by_second.segment(i, n) = f->by_second;
  }
  return at;
}

// The map's curvature with complex vectors, from their real and imaginary parts.
std::optional<ComplexVector> complex_curvature(const PlaneMap& map, const Vector& x, double p,
                                               double q, const ComplexVector& left,
                                               const ComplexVector& right) {
  ComplexVector sum = ComplexVector::Zero(x.size() + 2);
  const auto add = [&](const Vector& w, const Vector& v, const Complex& factor) {
    if (w.isZero(0.0) || v.isZero(0.0)) return true;
    const std::optional<Vector> part = map.curvature(x, p, q, w, v);
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
std::optional<Eigen::MatrixXcd> curvature(const PlaneMap& map, int period, const Vector& u,
                                          double p, double q,
                                          const std::vector<PlaneProduct>& products) {
  const Eigen::Index size = u.size(), n = size / period;
  Eigen::MatrixXcd rows =
      Eigen::MatrixXcd::Zero(static_cast<Eigen::Index>(products.size()), size + 2);
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    const PlaneProduct& product = products[static_cast<std::size_t>(row)];
    for (Eigen::Index i = 0; i < size; i += n) {
      const std::optional<ComplexVector> part = complex_curvature(
          map, u.segment(i, n), p, q, product.left.segment(i, n), product.right.segment(i, n));
      if (!part) return {};
      rows.row(row).segment(i, n) += part->head(n).transpose();
      rows.row(row).tail(2) += part->tail(2).transpose();
    }
  }
  return rows;
}

std::vector<Eigenvalue> multipliers(const PlaneMap& map, int period, const Vector& u, double p,
                                    double q, ErrorBounds errors) {
  const Eigen::Index n = u.size() / period;
  std::vector<Matrix> factors;
  for (Eigen::Index i = 0; i < u.size(); i += n) {
    const std::optional<PlaneMapEvaluation> f = map.evaluate(u.segment(i, n), p, q);
    if (!f) return {};
    factors.push_back(f->jacobian);
  }
  return product_eigenvalues(factors, errors);
}

}  // namespace

PlaneProblem periodic_points(const PlaneMap& map, int period) {
  PlaneProblem problem;
  problem.evaluate = [map, period](const Vector& u, double p, double q) {
    return evaluate(map, period, u, p, q);
  };
  problem.curvature = [map, period](const Vector& u, double p, double q,
                                    const std::vector<PlaneProduct>& products) {
    return curvature(map, period, u, p, q, products);
  };
  problem.multipliers = [map, period](const Vector& u, double p, double q, ErrorBounds errors) {
    return multipliers(map, period, u, p, q, errors);
  };
  return problem;
}

}  // namespace graze
