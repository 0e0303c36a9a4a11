#include "graze/orbit/problem/orbit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/base/linalg/detail/product_eigenvalues.hpp"
#include "graze/flow/exact/detail/arc_curve.hpp"
#include "graze/flow/variation/detail/transition.hpp"
#include "graze/motion/detail/clearance.hpp"
#include "graze/orbit/problem/detail/grazing_multipliers.hpp"
#include "graze/orbit/problem/detail/saltation.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {
namespace {

// What an impact and the flight after it do to a deviation.
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

// Impact factors larger than eps^(-1/4), in units of the flow, are taken apart (see orbit.hpp).
constexpr double kViolentNorm = 0x1p13;

// Velocity per displacement, 1/s, of each mode: a power of two, which does not round, next to the
// faster of mode and forcing.
Vector velocity_units(const System& system) {
  return system.omega.unaryExpr([&](double omega) {
    return std::ldexp(1.0, std::ilogb(std::max(omega, system.forcing()->frequency)));
  });
}

// How far a factor that ends in a flow may be from the one that is meant, in eps |factor|
// (Frobenius): the flow turns and shrinks mode j by exponents w t and delta t that carry a rounding
// each, which changes what comes out of it, its two rows, by eps (w + 2 delta) t of themselves in
// units in which the flow is round; those of velocity_units are within their ratio to w of that.
double rounding_of_flow(const System& system, const Matrix& factor, double t) {
  const Eigen::Index n = system.modes();
  const double slowest = system.forcing()->frequency, size = factor.squaredNorm();
  double sum = 0.0;
  for (Eigen::Index j = 0; j < n; ++j) {
    const double angle = 2.0 * t * (std::max(system.omega[j], slowest) + system.delta()[j]);
    sum += angle * angle * (factor.row(j).squaredNorm() + factor.row(n + j).squaredNorm());
  }
  return size > 0.0 ? std::sqrt(sum / size) : 0.0;
}

// Displacement of each mode next to those of the others: u^(-1/2), u its velocity unit, rounded to
// a power of two. A jump of velocity moves all modes alike, b in displacements and b/u in
// velocities; with units a the impact's largest entry is the larger of max(b/a) max(b^T a) and the
// same of (b/(a u), b^T a u), which are equal, and smallest, for a = u^(-1/2).
Vector displacement_units(const Vector& velocity_unit) {
  return velocity_unit.unaryExpr(
      [](double u) { return std::ldexp(1.0, -static_cast<int>(std::floor(0.5 * std::ilogb(u)))); });
}

// The lowest gap of another stop at the instant of an impact that turns the motion back from it
// too, if below `lowest`: a corner of that gap, and no minimum of any flight. Stops that are
// touched together are hit together.
std::optional<NearestApproach> lowest_corner(const System& system, const ImpactPattern& pattern,
                                             const ImpactPoint& point, const State& after,
                                             std::size_t flight, double lowest) {
  std::optional<NearestApproach> nearest;
  const Stop& stop = stop_of(system, pattern, flight);
  for (std::size_t k = 0; k < system.stops.size(); ++k) {
    if (static_cast<int>(k) == pattern.stops[flight]) continue;
    const Stop& other = system.stops[k];
    if (other.row.dot(point.before.qdot) < 0.0 || other.row.dot(after.qdot) > 0.0) continue;
    if (other.gap == stop.gap && other.row == stop.row) continue;  // hit together
    const GapValue<double> gap = gap_value<double>(other.row, point.before.q, other.gap);
    const double value = std::abs(gap.value) <= gap.rounding ? 0.0 : gap.value;
    if (!(value < lowest)) continue;
    lowest = value;
    nearest = NearestApproach{flight, static_cast<int>(k), 0.0, value};
  }
  return nearest;
}

}  // namespace

std::vector<OrbitImpact> ordered_impacts(const System& system, const ImpactPattern& pattern,
                                         const std::vector<ImpactPoint>& points) {
  std::size_t first = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (wrapped(points[i].theta) < wrapped(points[first].theta)) first = i;
  const double origin = points[first].theta - wrapped(points[first].theta);
  std::vector<OrbitImpact> impacts;
  for (std::size_t m = 0; m < points.size(); ++m) {
    const std::size_t i = (first + m) % points.size();
    const double lap = i < first ? kTurn * pattern.period : 0.0;
    const double theta = points[i].theta + lap - origin;
    const double phase = wrapped(theta);
    impacts.push_back({pattern.stops[i], static_cast<int>(std::lround((theta - phase) / kTurn)),
                       phase, stop_of(system, pattern, i).row.dot(points[i].before.qdot),
                       points[i].before});
  }
  return impacts;
}

ImpactPattern Orbit::pattern() const {
  ImpactPattern result{period, {}};
  for (const OrbitImpact& impact : impacts) result.stops.push_back(impact.stop);
  return result;
}

std::vector<ImpactPoint> Orbit::points() const {
  std::vector<ImpactPoint> result;
  for (const OrbitImpact& impact : impacts)
    result.push_back({impact.phase + kTurn * impact.period_index, impact.before});
  return result;
}

const OrbitImpact& leading_impact(const Orbit& orbit) {
  if (!orbit.sticks()) return orbit.impacts.front();
  return *std::max_element(
      orbit.impacts.begin(), orbit.impacts.end(),
      [](const OrbitImpact& a, const OrbitImpact& b) { return a.speed < b.speed; });
}

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
  const Eigen::Index n = system.modes();
  const Vector unit = velocity_units(system);
  if (auto limit = multipliers_at_grazing(system, pattern, points, unit, errors)) return *limit;
  const Vector size = displacement_units(unit);
  const auto scaled = [&](Matrix matrix) {
    matrix.topRows(n).array().colwise() /= size.array();
    matrix.leftCols(n).array().rowwise() *= size.transpose().array();
    matrix.bottomRows(n).array().colwise() /= unit.array() * size.array();
    matrix.rightCols(n).array().rowwise() *= (unit.array() * size.array()).transpose();
    return matrix;
  };
  std::vector<Matrix> factors;
  double violent = kViolentNorm, uncertainty = 0.0;
  std::ptrdiff_t most_violent = -1;
  for (const ImpactSegment& segment : impact_segments(system, pattern, points)) {
    Matrix factor = scaled(segment.flow.times(segment.saltation));
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
    factors.push_back(scaled(segment.saltation));
    factors.push_back(scaled(segment.flow.times(Matrix::Identity(2 * n, 2 * n))));
    uncertainty = std::max(uncertainty, rounding_of_flow(system, factors.back(), segment.duration));
  }
  // The second factor is the first one to be made triangular, before any change of basis mixes its
  // columns: those that are large next to grazing stay apart from the others.
  if (most_violent >= 0) {
    const auto count = static_cast<std::ptrdiff_t>(factors.size());
    std::rotate(factors.begin(), factors.begin() + (most_violent + count - 1) % count,
                factors.end());
  }
  return product_eigenvalues(factors, errors, uncertainty);
}

Admissibility admissibility(const System& system, const ImpactPattern& pattern,
                            const std::vector<ImpactPoint>& points) {
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  const double still = still_speed(system);
  constexpr double kUnfinished = -std::numeric_limits<double>::infinity();
  double lowest = std::numeric_limits<double>::infinity();
  Admissibility result;
  result.admissible = true;
  result.smallest_speed = result.shortest_flight = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Stop& stop = stop_of(system, pattern, i);
    const double speed = stop.row.dot(points[i].before.qdot);
    if (speed < result.smallest_speed) {
      result.smallest_speed = speed;
      result.slowest = i;
    }
    const double flight = flight_time(system, pattern, points, i);
    result.shortest_flight = std::min(result.shortest_flight, flight);
    if (!(speed > still) || !(flight > 0.0)) result.admissible = false;
    const State after = after_impact(stop, points[i].before);
    if (stop.restitution().at(speed) == 0.0)
      result.push = std::max(result.push.value_or(-std::numeric_limits<double>::infinity()),
                             stop.row.dot(vector_field(system, after, points[i].theta).qdot));
    if (const auto corner = lowest_corner(system, pattern, points[i], after, i, lowest)) {
      lowest = corner->gap;
      result.nearest = corner;
    }
    // Where one search could not be finished, the others change nothing.
    if (!(flight > 0.0) || lowest == kUnfinished) continue;
    arc.start(points[i].theta, after.q, after.qdot);
    for (std::size_t k = 0; k < system.stops.size(); ++k) {
      const bool here = static_cast<int>(k) == pattern.stops[i];
      const ArcCurve<double> curve(
          arc, gap_observable<double>(system.stops[k].row, system.stops[k].gap), flight, here);
      const std::optional<GapMinimum> minimum = lowest_minimum(curve, 0, lowest);
      if (!minimum) continue;
      lowest = minimum->gap;
      result.nearest = NearestApproach{i, static_cast<int>(k), minimum->s, minimum->gap};
      if (lowest == kUnfinished) break;
    }
  }
  if (result.nearest && result.nearest->gap < 0.0) result.admissible = false;
  if (result.push && *result.push > 0.0) result.admissible = false;
  return result;
}

Orbit make_orbit(const System& system, const ShootingProblem& problem, const Vector& solution) {
  return make_orbit(system, problem, solution,
                    orbit_multipliers(system, problem.pattern(), problem.unpack(system, solution)));
}

Orbit make_orbit(const System& system, const ShootingProblem& problem, const Vector& solution,
                 std::vector<Eigenvalue> multipliers) {
  const std::vector<ImpactPoint> points = problem.unpack(system, solution);
  Orbit orbit;
  orbit.period = problem.pattern().period;
  orbit.impacts = ordered_impacts(system, problem.pattern(), points);
  orbit.residual = problem.residual(system, solution).cwiseAbs().maxCoeff();
  orbit.multipliers = std::move(multipliers);
  orbit.stable = stability(orbit.multipliers);
  const Admissibility classification = admissibility(system, problem.pattern(), points);
  orbit.admissible = classification.admissible;
  orbit.clearance = classification.clearance();
  return orbit;
}

}  // namespace graze
