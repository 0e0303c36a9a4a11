#include "graze/orbit/problem/detail/grazing_multipliers.hpp"

#include <cmath>
#include <limits>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/problem/detail/saltation.hpp"

namespace graze {
namespace {

// Smallest singular part, in units of the flow, for which the limit is used: its error is the
// inverse, a hundredth of the error of the finite multipliers in a product.
constexpr double kSingular = 0x1p44;

// For an impact at speed v: jump of velocity per v, and the acceleration towards the stop just
// before it, m/s^2. Where r depends on v it is taken at v = 0.
struct Slow {
  double jump = 0.0, push = 0.0, speed = 0.0;
};

Slow slow_impact(const System& system, const Stop& stop, const ImpactPoint& point) {
  const double v = stop.row.dot(point.before.qdot);
  return {1.0 + stop.restitution().at(std::abs(v)),
          stop.row.dot(vector_field(system, point.before, point.theta).qdot), v};
}

// The orthogonal complement of a vector, n x (n - 1).
Matrix complement(const Vector& vector) {
  return orthonormal_columns<double>(vector, vector.size()).rightCols(vector.size() - 1);
}

}  // namespace

std::optional<std::vector<Eigenvalue>> multipliers_at_grazing(
    const System& system, const ImpactPattern& pattern, const std::vector<ImpactPoint>& points,
    const Vector& unit, ErrorBounds errors) {
  const Eigen::Index n = system.modes();
  std::optional<std::size_t> grazing;
  Slow slow;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Stop& stop = stop_of(system, pattern, i);
    const Slow here = slow_impact(system, stop, points[i]);
    const double size = std::abs(here.jump * here.push) *
                        stop.direction().cwiseQuotient(unit).norm() * stop.row.norm();
    if (!(size > kSingular * std::abs(here.speed))) continue;
    if (grazing) return {};
    grazing = i;
    slow = here;
  }
  if (!grazing) return {};
  const Stop& stop = stop_of(system, pattern, *grazing);
  // S0 and x0 next to each other. The jump of velocities changes the damping forces.
  Matrix moved = Matrix::Zero(2 * n, 2 * n + 1);
  moved.leftCols(2 * n).setIdentity();
  moved.topLeftCorner(n, n) -= slow.jump * stop.direction() * stop.row.transpose();
  moved.block(n, n, n, n) -= slow.jump * stop.direction() * stop.row.transpose();
  moved.block(n, 0, n, n) +=
      2.0 * slow.jump * system.delta().cwiseProduct(stop.direction()) * stop.row.transpose();
  moved.col(2 * n).tail(n) = slow.jump * slow.push * stop.direction();
  const ExactFlow<double> flow(system);
  for (std::size_t passed = 0; passed < points.size(); ++passed) {
    const std::size_t i = (*grazing + passed) % points.size();
    if (passed > 0)
      moved = (saltation_matrix(system, stop_of(system, pattern, i), points[i].before,
                                points[i].theta) *
               moved)
                  .eval();
    moved = flow_matrix(system, flow, flight_time(system, pattern, points, i)).times(moved);
  }
  moved.bottomRows(n).array().colwise() /= unit.array();
  moved.middleCols(n, n).array().rowwise() *= unit.transpose().array();
  Vector row = Vector::Zero(2 * n);
  row.head(n) = stop.row;
  const Vector thrown = moved.col(2 * n);
  const double gain = row.dot(thrown);
  if (!(std::abs(gain) >
        std::sqrt(std::numeric_limits<double>::epsilon()) * row.norm() * thrown.norm()))
    return {};
  const Matrix plane = complement(row), across = complement(thrown);
  const Matrix finite = LuFactors(across.transpose() * plane)
                            .solve_columns(across.transpose() * moved.leftCols(2 * n) * plane);
  std::vector<Eigenvalue> list = eigenvalues(finite, errors);
  if (list.empty()) return {};
  const double least = std::numeric_limits<double>::min();
  list.push_back({Complex(gain / std::fmax(std::abs(slow.speed), least)), 0.0});
  sort_eigenvalues(list);
  return list;
}

}  // namespace graze
