#include "graze/bifurcation/completion_curve.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "graze/orbit/chatter_completion.hpp"
#include "graze/orbit/passage_events.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// Of differences, in units of the unknowns and the parameters' ranges: the distance is known to
// some 1e-13, and smooth over some 1e-5.
constexpr double kStep = 1e-8;

}  // namespace

CompletionCurve::CompletionCurve(const PassageEquations& equations) : equations_(equations) {
  problem_.first = equations.shooting().size();
  problem_.problem.evaluate = [this](const Vector& y, Parameters at) { return evaluate(y, at[0]); };
  problem_.problem.wrap = Vector::Zero(problem_.first + 1);
  problem_.problem.wrap.head(problem_.first) = equations.shooting().wrap();
  problem_.proceed = [this](const BranchPoint& previous, const BranchPoint& here) {
    const auto before = itinerary_at(previous), now = itinerary_at(here);
    return before && now && !locus_end_between(*before, *now, equations_.speed_unit());
  };
  problem_.resolves = [this](const BranchPoint& from, const BranchPoint& to) {
    const double second = (to.parameter - from.parameter) / equations_.unit(1);
    if (std::hypot((to.u - from.u).norm(), second) <= kLocusBracket) return true;
    const auto before = itinerary_at(from), now = itinerary_at(to);
    return before && now && before->events == now->events;
  };
}

OrbitLocusEnd CompletionCurve::end_between(const BranchPoint& a, const BranchPoint& b) const {
  const auto before = itinerary_at(a), now = itinerary_at(b);
  if (!before || !now) return OrbitLocusEnd::kNotConverged;
  return locus_end_between(*before, *now, equations_.speed_unit())
      .value_or(OrbitLocusEnd::kNotConverged);
}

Vector CompletionCurve::pack(const Vector& u, double first) const {
  Vector y(problem_.first + 1);
  y << u, first / equations_.unit(0);
  return y;
}

double CompletionCurve::first_of(const BranchPoint& point) const {
  return point.u[problem_.first] * equations_.unit(0);
}

const System* CompletionCurve::system_at(const Vector& y, double second) const {
  return equations_.system_at(std::array{y[problem_.first] * equations_.unit(0), second});
}

std::optional<ZeroEvaluation> CompletionCurve::evaluate(const Vector& y, double second) const {
  const Eigen::Index n = problem_.first;
  const auto orbit =
      equations_.problem().evaluate(y.head(n), std::array{y[n] * equations_.unit(0), second});
  if (!orbit) return {};
  const auto distance = [&](const Vector& there, double value) {
    const System* system = system_at(there, value);
    return system ? completion_distance(*system, equations_.shooting(), there.head(n))
                  : std::optional<double>();
  };
  const auto here = distance(y, second);
  if (!here) return {};
  Vector slope(n + 2);
  for (Eigen::Index j = 0; j < n + 2; ++j) {
    const Vector step = j <= n ? Vector(kStep * Vector::Unit(n + 1, j)) : Vector::Zero(n + 1);
    const double by = j <= n ? 0.0 : kStep * equations_.unit(1);
    const auto ahead = distance(y + step, second + by), behind = distance(y - step, second - by);
    if (!ahead || !behind) return {};
    slope[j] = (*ahead - *behind) / (2.0 * kStep);
  }
  ZeroEvaluation sum{Vector(n + 1), Matrix(n + 1, n + 1), Matrix(n + 1, 1),
                     Matrix::Zero(n + 1, n + 1)};
  sum.residual << orbit->residual, *here;
  sum.jacobian.topLeftCorner(n, n) = orbit->jacobian;
  sum.jacobian.col(n).head(n) = orbit->by_parameters.col(0) * equations_.unit(0);
  sum.jacobian.row(n) = slope.head(n + 1).transpose();
  sum.by_parameters << orbit->by_parameters.col(1), slope[n + 1] / equations_.unit(1);
  return sum;
}

std::optional<ReleaseReturn> CompletionCurve::return_at(const BranchPoint& point,
                                                        bool minima) const {
  const System* system = system_at(point.u, point.parameter);
  auto back = system
                  ? return_of(*system, equations_.shooting(), point.u.head(problem_.first), minima)
                  : std::optional<ReleaseReturn>();
  if (!back || back->returns) return back;
  const Instant<double>& end = back->passage.end.instant;
  back->passage.holds.push_back({*equations_.layout().released, end, end});
  back->itinerary = itinerary_of(back->passage, still_speed(*system));
  return back;
}

std::optional<Itinerary> CompletionCurve::itinerary_at(const BranchPoint& point) const {
  const auto back = return_at(point, false);
  return back ? std::optional(back->itinerary) : std::nullopt;
}

OrbitLocusEnd CompletionCurve::end_at(const BranchPoint& last) const {
  const auto back = return_at(last, true);
  return back && grazes_at(back->passage, back->itinerary,
                           motion_scale(*system_at(last.u, last.parameter)))
             ? OrbitLocusEnd::kGrazing
             : OrbitLocusEnd::kNotConverged;
}

std::optional<Orbit> CompletionCurve::orbit_at(const BranchPoint& point) const {
  const System* system = system_at(point.u, point.parameter);
  if (!system) return {};
  const PassageShooting& shooting = equations_.shooting();
  const Vector u = point.u.head(problem_.first);
  const auto start =
      shooting.map().start_of(*system, shooting.at_section(u, 0), shooting.theta_of(u));
  const auto back = return_at(point, true);
  if (!start || !back) return {};
  const std::vector<Passage> passages{back->passage};
  Orbit orbit;
  orbit.period = equations_.period();
  orbit.admissible = true;
  orbit.clearance = passages.front().clearance();
  orbit.section = OrbitSection{{}, {*start}, shooting.map().options().closure_speed};
  add_events(*system, passages, orbit.period, {}, orbit);
  return orbit.impacts.empty() ? std::nullopt : std::optional(std::move(orbit));
}

}  // namespace graze
