#include "graze/continuation/map.hpp"

#include <utility>

#include "graze/base/product_eigenvalues.hpp"

namespace graze {
namespace {

std::optional<ZeroEvaluation> evaluate(const Map& map, int period, const Vector& u,
                                       double parameter) {
  const Eigen::Index size = u.size(), n = size / period;
  ZeroEvaluation at{Vector(size), Matrix::Zero(size, size), Vector(size)};
  for (Eigen::Index i = 0; i < size; i += n) {
    const Eigen::Index next = (i + n) % size;
    const std::optional<MapEvaluation> f = map(u.segment(i, n), parameter);
    if (!f) return {};
    at.residual.segment(i, n) = f->image - u.segment(next, n);
    at.jacobian.block(i, i, n, n) += f->jacobian;
    at.jacobian.block(i, next, n, n) -= Matrix::Identity(n, n);
    at.parameter_derivative.segment(i, n) = f->parameter_derivative;
  }
  return at;
}

std::vector<Eigenvalue> multipliers(const Map& map, int period, const Vector& u, double parameter,
                                    ErrorBounds errors) {
  const Eigen::Index n = u.size() / period;
  std::vector<Matrix> factors;
  for (Eigen::Index i = 0; i < u.size(); i += n) {
    const std::optional<MapEvaluation> f = map(u.segment(i, n), parameter);
    if (!f) return {};
    factors.push_back(f->jacobian);
  }
  return product_eigenvalues(factors, errors);
}

}  // namespace

ZeroProblem periodic_points(const Map& map, int period) {
  ZeroProblem problem;
  problem.evaluate = [map, period](const Vector& u, double parameter) {
    return evaluate(map, period, u, parameter);
  };
  problem.multipliers = [map, period](const Vector& u, double parameter, ErrorBounds errors) {
    return multipliers(map, period, u, parameter, errors);
  };
  return problem;
}

BranchPoint twice_round(const BranchPoint& point) {
  const Eigen::Index n = point.u.size();
  BranchPoint twice = point;
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
