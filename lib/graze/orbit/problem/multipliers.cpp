// The multipliers of an orbit that consists of flights from impact to impact.
#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/base/linalg/detail/product_eigenvalues.hpp"
#include "graze/base/linalg/detail/secular_eigenvalues.hpp"
#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/problem/detail/grazing_multipliers.hpp"
#include "graze/orbit/problem/detail/saltation.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {
namespace {

// The effect of an impact and the flight after it on a deviation.
struct ImpactSegment {
  Matrix saltation;
  FlowMatrix flow;
  double duration;  // s
};

std::vector<ImpactSegment> impact_segments(const System& system, const ImpactPattern& pattern,
                                           const std::vector<ImpactPoint>& points) {
  const ExactFlow<double> flow(system);
  std::vector<ImpactSegment> segments;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Stop& stop = stop_of(system, pattern, i);
    const double duration = flight_time(system, pattern, points, i);
    segments.push_back({saltation_matrix(system, stop, points[i].before, points[i].theta),
                        flow_matrix(system, flow, duration), duration});
  }
  return segments;
}

// Impact factors larger than eps^(-1/4), in units of the flow, are kept separate (see orbit.hpp).
constexpr double kViolentNorm = 0x1p13;

// Velocity per displacement, 1/s, of each mode: a power of two, which causes no rounding, near the
// larger of the frequencies of mode and forcing.
Vector velocity_units(const System& system) {
  return system.omega.unaryExpr([&](double omega) {
    return std::ldexp(1.0, std::ilogb(std::max(omega, system.forcing()->frequency)));
  });
}

// Error of each mode's flow over t, in eps of it: the exponents w t and delta t carry a rounding
// each, which changes the flow, in its two rows, by eps (w + 2 delta) t of themselves in units in
// which it is a rotation; in those of velocity_units by up to their ratio to w of that.
Vector roundings_of_modes(const System& system, double t) {
  const double slowest = system.forcing()->frequency;
  return 2.0 * t * (system.omega.cwiseMax(slowest) + system.delta());
}

// Error of a factor that ends in a flow, in eps |factor| (Frobenius).
double rounding_of_flow(const System& system, const Matrix& factor, double t) {
  const Eigen::Index n = system.modes();
  const double size = factor.squaredNorm();
  const Vector of_rows =
      factor.topRows(n).rowwise().squaredNorm() + factor.bottomRows(n).rowwise().squaredNorm();
  const double sum = roundings_of_modes(system, t).cwiseAbs2().dot(of_rows);
  return size > 0.0 ? std::sqrt(sum / size) : 0.0;
}

// Unit of displacement of each mode relative to the others: u^(-1/2), u its velocity unit, rounded
// to a power of two. A jump of velocity moves all modes alike, b in displacements and b/u in
// velocities; with units a the impact's largest entry is the larger of max(b/a) max(b^T a) and the
// same of (b/(a u), b^T a u), which are equal, and smallest, for a = u^(-1/2).
Vector displacement_units(const Vector& velocity_unit) {
  return velocity_unit.unaryExpr(
      [](double u) { return std::ldexp(1.0, -static_cast<int>(std::floor(0.5 * std::ilogb(u)))); });
}

// The units of a deviation: displacement and velocity of each mode.
struct DeviationUnits {
  Vector displacement, velocity;

  explicit DeviationUnits(const Vector& velocity_unit)
      : displacement(displacement_units(velocity_unit)),
        velocity(velocity_unit.cwiseProduct(displacement)) {}

  // A matrix from deviations to deviations.
  Matrix scaled(Matrix matrix) const {
    const Eigen::Index n = displacement.size();
    matrix.topRows(n).array().colwise() /= displacement.array();
    matrix.bottomRows(n).array().colwise() /= velocity.array();
    matrix.leftCols(n).array().rowwise() *= displacement.transpose().array();
    matrix.rightCols(n).array().rowwise() *= velocity.transpose().array();
    return matrix;
  }
};

// With fewer modes per impact than this, the product is cheaper.
constexpr Eigen::Index kManyModes = 8;

// An impact and the flight after it, for the secular equation; nullopt when the impact factor is
// larger than kViolentNorm.
std::optional<JumpAndFlow> jump_and_flow(const System& system, const Stop& stop,
                                         const ImpactPoint& point, double duration,
                                         const ExactFlow<double>& flow,
                                         const DeviationUnits& units) {
  const Eigen::Index n = system.modes();
  auto [from, to] = saltation_factors(system, stop, point.before, point.theta);
  for (Matrix* const side : {&from, &to}) {
    const bool gives = side == &from;
    for (Eigen::Index j = 0; j < n; ++j) {
      const double a = units.displacement[j], b = units.velocity[j];
      side->row(j) *= gives ? 1.0 / a : a;
      side->row(n + j) *= gives ? 1.0 / b : b;
    }
  }
  const FlowMatrix free = flow_matrix(system, flow, duration);
  const Vector ratio = units.velocity.cwiseQuotient(units.displacement);
  JumpAndFlow factor{std::move(from),
                     std::move(to),
                     free.qq,
                     free.qv.cwiseProduct(ratio),
                     free.vq.cwiseQuotient(ratio),
                     free.vv,
                     roundings_of_modes(system, duration)};
  if (!(factor.norm() <= kViolentNorm)) return {};
  return factor;
}

// The multipliers by the secular equation; nullopt when the product is preferable.
std::optional<std::vector<Eigenvalue>> secular_multipliers(const System& system,
                                                           const ImpactPattern& pattern,
                                                           const std::vector<ImpactPoint>& points,
                                                           const DeviationUnits& units,
                                                           ErrorBounds errors) {
  if (system.modes() < kManyModes * (1 + pattern.impacts())) return {};
  const ExactFlow<double> flow(system);
  std::vector<JumpAndFlow> factors;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::optional<JumpAndFlow> factor =
        jump_and_flow(system, stop_of(system, pattern, i), points[i],
                      flight_time(system, pattern, points, i), flow, units);
    if (!factor) return {};
    factors.push_back(std::move(*factor));
  }
  return secular_eigenvalues(factors, errors);
}

}  // namespace

MultiplierCount count_multipliers(const std::vector<Eigenvalue>& multipliers) {
  MultiplierCount count;
  for (const Eigenvalue& multiplier : multipliers) {
    const double excess = std::abs(multiplier.value) - 1.0;
    if (std::abs(excess) <= multiplier.error)
      ++count.undecided;
    else if (!(excess < 0.0))
      ++count.outside;
  }
  return count;
}

std::optional<bool> stability(const std::vector<Eigenvalue>& multipliers) {
  const MultiplierCount count = count_multipliers(multipliers);
  if (count.outside > 0) return false;
  return count.undecided == 0 && !multipliers.empty() ? std::optional(true) : std::nullopt;
}

std::vector<Matrix> impact_factors(const System& system, const ImpactPattern& pattern,
                                   const std::vector<ImpactPoint>& points) {
  std::vector<Matrix> factors;
  for (const ImpactSegment& segment : impact_segments(system, pattern, points))
    factors.push_back(segment.flow.times(segment.saltation));
  return factors;
}

Matrix monodromy_matrix(const System& system, const ImpactPattern& pattern,
                        const std::vector<ImpactPoint>& points) {
  Matrix product = Matrix::Identity(2 * system.modes(), 2 * system.modes());
  for (const Matrix& factor : impact_factors(system, pattern, points))
    product = (factor * product).eval();
  return product;
}

std::vector<Eigenvalue> orbit_multipliers(const System& system, const ImpactPattern& pattern,
                                          const std::vector<ImpactPoint>& points,
                                          ErrorBounds errors) {
  const Vector unit = velocity_units(system);
  if (auto limit = multipliers_at_grazing(system, pattern, points, unit, errors)) return *limit;
  const DeviationUnits units(unit);
  if (auto roots = secular_multipliers(system, pattern, points, units, errors)) return *roots;
  const Eigen::Index n = system.modes();
  std::vector<Matrix> factors;
  double violent = kViolentNorm, uncertainty = 0.0;
  std::ptrdiff_t most_violent = -1;
  for (const ImpactSegment& segment : impact_segments(system, pattern, points)) {
    Matrix factor = units.scaled(segment.flow.times(segment.saltation));
    const double violence = factor.norm();
    uncertainty = std::max(uncertainty, rounding_of_flow(system, factor, segment.duration));
    if (violence <= kViolentNorm) {
      factors.push_back(std::move(factor));
      continue;
    }
    if (violence > violent) {
      violent = violence;
      most_violent = static_cast<std::ptrdiff_t>(factors.size());
    }
    factors.push_back(units.scaled(segment.saltation));
    factors.push_back(units.scaled(segment.flow.times(Matrix::Identity(2 * n, 2 * n))));
    uncertainty = std::max(uncertainty, rounding_of_flow(system, factors.back(), segment.duration));
  }
  // The second factor is made triangular first, before any change of basis mixes its columns: those
  // that are large next to grazing stay separate from the others.
  if (most_violent >= 0) {
    const auto count = static_cast<std::ptrdiff_t>(factors.size());
    std::rotate(factors.begin(), factors.begin() + (most_violent + count - 1) % count,
                factors.end());
  }
  return product_eigenvalues(factors, errors, uncertainty);
}

}  // namespace graze
