#include "graze/bifurcation/loci/detail/level_curve.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/bifurcation/trace/detail/orbit_kinds.hpp"
#include "graze/continuation/branch/detail/slope.hpp"

namespace graze {
namespace {

// Steps of differences, in units of the unknowns and the parameters' ranges. Numbers are known to
// some 1e-14 of their size: a slope by the second power of this step is known to 1e-10, one by the
// fourth power of the other to 1e-11.
constexpr double kNumberStep = 1e-5, kSlopeStep = 1e-3;
// Steps onto the orbits end after one this short, whose successor would be its square; longer ones
// lead to other orbits.
constexpr double kNear = 1e-8, kFarthest = 0.1;
constexpr int kMostSteps = 8;

// Its solution at a place; of orbits at which nothing else is asked for.
Orbit orbit_of(const OrbitLocusPoint& at, int period, std::vector<Eigenvalue> multipliers) {
  Orbit orbit;
  orbit.period = period;
  orbit.impacts = at.impacts;
  orbit.sticking = at.sticking;
  orbit.section = at.section;
  orbit.multipliers = std::move(multipliers);
  orbit.admissible = at.admissible;
  return orbit;
}

}  // namespace

LevelCurve::LevelCurve(const OrbitProblem& equations, Eigen::Index n, const OrbitLevel& level,
                       std::array<double, 2> units)
    : OrbitCurve(equations, n, 0, units[0], orbits_along(equations)),
      level_(level),
      second_unit_(units[1]) {
  ZeroProblem& zero = problem_.problem;
  zero.evaluate = [this](const Vector& y, Parameters at) {
    Vector x(y.size() + 1);
    x << y, at[0] / second_unit_;
    return with(y, at[0], remembered_.answer(x, [&] { return condition(x); }));
  };
  if (equations.has_multipliers())
    zero.multipliers = [this](const Vector& y, Parameters at, ErrorBounds errors) {
      return equations_.problem().multipliers(y.head(problem_.first), parameters_of(y, at[0]),
                                              errors);
    };
}

std::array<double, 2> LevelCurve::values_of(const Vector& x) const {
  const Eigen::Index n = problem_.first;
  return {x[n] * unit_, x[n + 1] * second_unit_};
}

// By the shortest steps onto the solutions of the equations.
std::optional<LevelCurve::Place> LevelCurve::nearest_orbit(Vector x) const {
  const Eigen::Index n = problem_.first;
  for (int step = 0; step < kMostSteps; ++step) {
    const auto orbit = equations_.problem().evaluate(x.head(n), values_of(x));
    if (!orbit) return {};
    Matrix rows(n + 2, n);
    rows << orbit->jacobian.transpose(), orbit->by_parameters.col(0).transpose() * unit_,
        orbit->by_parameters.col(1).transpose() * second_unit_;
    const PivotedLu<double> gram(Matrix(rows.transpose() * rows));
    const Vector change = rows * gram.solve(orbit->residual);
    x -= change;
    if (!(change.norm() < kFarthest)) return {};
    if (change.norm() <= kNear)
      return Place{x, orthonormal_columns<double>(rows, n + 2).rightCols(2)};
  }
  return {};
}

std::optional<double> LevelCurve::excess(const Place& at) const {
  const std::array<double, 2> values = values_of(at.x);
  const Vector u = at.x.head(problem_.first);
  const auto place = orbits().place({u, values[0], values[1], 0.0, {}}, {});
  const System* system = place ? equations_.system_at(values) : nullptr;
  if (!system) return {};
  std::vector<Eigenvalue> multipliers;
  if (equations_.has_multipliers())
    multipliers = equations_.problem().multipliers(u, values, ErrorBounds::kLeftOut);
  const std::optional<double> number =
      level_.number(equations_.scene_at(values), *system,
                    orbit_of(place->at, equations_.period(), std::move(multipliers)));
  return number ? std::optional(level_.excess(*number)) : std::nullopt;
}

std::optional<double> LevelCurve::value(const Place& at) const {
  if (level_.value) return excess(at);
  // The direction in which the second parameter stays.
  const Vector last = at.beside.row(at.beside.rows() - 1);
  Vector along = (at.beside.col(0) * last[1] - at.beside.col(1) * last[0]).normalized();
  if (along[problem_.first] < 0.0) along *= -1.0;
  const std::optional<double> here = excess(at);
  return slope_at_zero(kSlopeStep, [&](double s) -> std::optional<double> {
    const auto there = nearest_orbit(at.x + s * along);
    const std::optional<double> number = there ? excess(*there) : std::nullopt;
    return number && here ? std::optional(level_.change(*here, *number)) : std::nullopt;
  });
}

std::optional<OrbitCurve::Condition> LevelCurve::condition(const Vector& x) const {
  const std::optional<Place> here = nearest_orbit(x);
  const std::optional<double> at = here ? value(*here) : std::nullopt;
  if (!at) return {};
  Vector slope = Vector::Zero(x.size());
  for (const auto& direction : here->beside.colwise()) {
    const auto ahead = nearest_orbit(here->x + kNumberStep * direction),
               behind = nearest_orbit(here->x - kNumberStep * direction);
    const auto more = ahead ? value(*ahead) : std::nullopt;
    const auto less = behind ? value(*behind) : std::nullopt;
    if (!more || !less) return {};
    slope += (*more - *less) / (2.0 * kNumberStep) * direction;
  }
  return Condition{*at, slope.head(x.size() - 1), slope[x.size() - 1] / second_unit_};
}

}  // namespace graze
