#include "graze/bifurcation/strobe_equations.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/half_period.hpp"
#include "graze/flow/sprung_deviation.hpp"
#include "graze/orbit/solve.hpp"

namespace graze {

namespace {

// Slopes of the map are known to about this, in its units: ten times what a step of the deviations
// is.
constexpr double kMapAccuracy = 10.0 * kDeviationTolerance;
// So differences of slopes err least over steps of its cube root, in units of the map and of the
// parameters.
const double kStep = std::cbrt(kMapAccuracy);
// The test for a multiplier is formed from slopes: it vanishes to what these are known to, times
// what solving with them costs.
constexpr double kCritical = 1e3 * kMapAccuracy;

System own_system(const Scene& scene, const std::string& parameter) {
  const SystemFamily family(scene, parameter);
  return *family.at(family.value());
}

}  // namespace

StrobeEquations::StrobeEquations(const Scene& scene, const std::vector<std::string>& parameters,
                                 std::vector<double> units, const PassageOptions& options,
                                 int period, double section)
    : systems_(scene, parameters),
      units_(std::move(units)),
      scale_(motion_scale(own_system(scene, parameters.front()))),
      map_(own_system(scene, parameters.front()), options, section),
      period_(period) {
  Map map;
  map.evaluate = [this](const Vector& x, Parameters at) { return evaluate(x, at); };
  map.curvature = [this](const Vector& x, Parameters at, const Vector& left, const Vector& right) {
    return curvature(x, at, left, right);
  };
  problem_ = periodic_points(map, period);
}

double StrobeEquations::critical_tolerance() { return kCritical; }

std::optional<MapEvaluation> StrobeEquations::evaluate(const Vector& x, Parameters at) const {
  const System* system = systems_.at(at);
  if (!system) return {};
  MapEvaluation result;
  result.by_parameters.resize(x.size(), static_cast<Eigen::Index>(at.size()));
  for (std::size_t k = 0; k < at.size(); ++k) {
    const System* tangent = systems_.tangent_at(at, k);
    if (!tangent) return {};
    const auto column = static_cast<Eigen::Index>(k);
    if (k > 0) {
      const std::optional<Vector> rate = map_.rate(*system, x, *tangent);
      if (!rate) return {};
      result.by_parameters.col(column) = *rate;
      continue;
    }
    std::optional<StrobeMap::Image> image = map_.image(*system, x, tangent);
    if (!image) return {};
    result.image = std::move(image->image);
    result.jacobian = std::move(image->jacobian);
    result.by_parameters.col(column) = image->by_parameter;
  }
  return result;
}

std::optional<double> StrobeEquations::product(const Vector& x, Parameters at, const Vector& left,
                                               const Vector& right) const {
  const System* system = systems_.at(at);
  const auto image = system ? map_.image(*system, x) : std::nullopt;
  return image ? std::optional(left.dot(image->jacobian * right)) : std::nullopt;
}

std::optional<Vector> StrobeEquations::curvature(const Vector& x, Parameters at, const Vector& left,
                                                 const Vector& right) const {
  Vector slopes(x.size() + static_cast<Eigen::Index>(at.size()));
  for (Eigen::Index j = 0; j < slopes.size(); ++j) {
    const auto parameter = static_cast<std::size_t>(std::max<Eigen::Index>(j - x.size(), 0));
    const double step = j < x.size() ? kStep : kStep * units_[parameter];
    const auto beside = [&](double by) {
      Vector moved = x;
      std::vector<double> there(at.begin(), at.end());
      (j < x.size() ? moved[j] : there[parameter]) += by;
      return product(moved, there, left, right);
    };
    const auto ahead = beside(step), behind = beside(-step);
    if (!ahead || !behind) return {};
    slopes[j] = (*ahead - *behind) / (2.0 * step);
  }
  return slopes;
}

Vector StrobeEquations::halves_differ(const BranchPoint& solution) const {
  if (period_ % 2 != 0) return {};
  const Eigen::Index half = solution.u.size() / 2;
  return solution.u.tail(half) - solution.u.head(half);
}

bool StrobeEquations::is_half(const BranchPoint& solution) const {
  return period_ % 2 == 0 &&
         halves_differ(solution).norm() <= kShootingAccuracy * (1.0 + solution.u.norm());
}

bool StrobeEquations::passes_half(const BranchPoint& a, const BranchPoint& b) const {
  return turns_round(halves_differ(a), halves_differ(b), kShootingAccuracy * (1.0 + a.u.norm()));
}

std::optional<OrbitBranchPoint> StrobeEquations::judge(const BranchPoint& solution) const {
  return judged_.answer({solution.u, solution.parameter}, [&]() -> std::optional<OrbitBranchPoint> {
    const System* system = systems_.at(solution.parameters());
    if (!system) return {};
    std::vector<Eigenvalue> multipliers = solution.multipliers;
    if (multipliers.empty())
      multipliers = problem_.multipliers(solution.u, solution.parameters(), ErrorBounds::kGiven);
    std::optional<Orbit> orbit =
        orbit_of(*system, map_, solution.u, std::move(multipliers), solution.residual);
    if (!orbit) return {};
    return point_of_branch(solution.parameter, std::move(*orbit));
  });
}

std::optional<OrbitBranchPoint> StrobeEquations::judge_touching(const BranchPoint& solution,
                                                                const StrobeTouch& touch) const {
  const System* system = systems_.at(solution.parameters());
  if (!system) return {};
  std::optional<Orbit> orbit =
      touching_orbit_of(*system, map_, solution.u, touch, solution.residual);
  if (!orbit) return {};
  orbit->multipliers = problem_.multipliers(solution.u, solution.parameters(), ErrorBounds::kGiven);
  return point_of_branch(solution.parameter, std::move(*orbit));
}

std::optional<OrbitBranchPoint> StrobeEquations::judge_without(const BranchPoint& solution,
                                                               const StrobeTouch& touch) const {
  std::optional<OrbitBranchPoint> at = judge_touching(solution, touch);
  if (!at) return {};
  Orbit& orbit = at->orbit;
  const auto slowest = std::min_element(
      orbit.impacts.begin(), orbit.impacts.end(),
      [](const OrbitImpact& a, const OrbitImpact& b) { return a.speed < b.speed; });
  orbit.impacts.erase(slowest);
  if (orbit.impacts.empty()) return {};
  orbit.clearance = 0.0;
  return point_of_branch(solution.parameter, std::move(orbit));
}

std::vector<int> StrobeEquations::stops_met(const BranchPoint& solution) const {
  const System* system = systems_.at(solution.parameters());
  const std::optional<Orbit> orbit =
      system ? orbit_of(*system, map_, solution.u, {}, solution.residual) : std::nullopt;
  if (!orbit) return {};
  std::vector<int> stops = orbit->pattern().stops;
  std::sort(stops.begin(), stops.end());
  return stops;
}

std::vector<StrobeTouch> StrobeEquations::touches_near(const BranchPoint& solution) const {
  const System* system = systems_.at(solution.parameters());
  if (!system) return {};
  std::vector<StrobeTouch> touches = graze::touches_near(*system, map_, solution.u);
  std::erase_if(touches, [&](const StrobeTouch& touch) {
    return !system->stops[static_cast<std::size_t>(touch.stop)].is_compliant();
  });
  return touches;
}

bool StrobeEquations::sets_in_smoothly(const BranchPoint& solution, int stop) const {
  const System* system = systems_.at(solution.parameters());
  const Stop* met = system ? &system->stops[static_cast<std::size_t>(stop)] : nullptr;
  return met && met->is_compliant() && met->force().sets_in_smoothly();
}

StrobeEquations::Place StrobeEquations::place_of(double psi) const {
  const double whole = std::floor(psi / kTurn);
  const Eigen::Index turn = static_cast<Eigen::Index>(whole) % period_;
  return {turn < 0 ? turn + period_ : turn, std::clamp(psi - whole * kTurn, 0.0, kTurn)};
}

std::vector<double> StrobeEquations::parameters_of(const Vector& y, Parameters behind) const {
  std::vector<double> all{y[y.size() - 2] * units_[0]};
  all.insert(all.end(), behind.begin(), behind.end());
  return all;
}

std::optional<ZeroEvaluation> StrobeEquations::touching(const Vector& y, Parameters behind,
                                                        int stop) const {
  const Eigen::Index n = y.size() - 2, size = map_.size();
  const std::vector<double> parameters = parameters_of(y, behind);
  const std::optional<ZeroEvaluation> orbit = problem_.evaluate(y.head(n), parameters);
  if (!orbit) return {};
  const System& system = *systems_.at(parameters);
  std::vector<const System*> tangents;
  for (std::size_t k = 0; k < parameters.size(); ++k)
    tangents.push_back(systems_.tangent_at(parameters, k));
  const Place place = place_of(y[n + 1]);
  const auto at = map_.within(system, y.segment(place.turn * size, size), place.angle, tangents);
  if (!at) return {};
  const auto index = static_cast<std::size_t>(stop);
  const Stop& met = system.stops[index];
  // Of a state's rate, by the unit of depths and that of speeds.
  const auto seen = [&](const State& rate) {
    return Eigen::Vector2d(met.row.dot(rate.q) / length(), met.row.dot(rate.qdot) / speed_unit());
  };
  Matrix by_parameters(n + 2, orbit->by_parameters.cols());
  by_parameters.topRows(n) = orbit->by_parameters;
  for (std::size_t k = 0; k < tangents.size(); ++k) {
    const Stop& rate = tangents[k]->stops[index];
    by_parameters.col(static_cast<Eigen::Index>(k)).tail(2) =
        seen(at->by_parameters[k]) +
        Eigen::Vector2d((rate.row.dot(at->state.q) - rate.gap) / length(),
                        rate.row.dot(at->state.qdot) / speed_unit());
  }
  ZeroEvaluation result{Vector(n + 2), Matrix::Zero(n + 2, n + 2), Matrix()};
  result.residual << orbit->residual, (met.row.dot(at->state.q) - met.gap) / length(),
      met.row.dot(at->state.qdot) / speed_unit();
  result.jacobian.topLeftCorner(n, n) = orbit->jacobian;
  result.jacobian.row(n).segment(place.turn * size, size) =
      met.row.transpose() * at->by_state.q / length();
  result.jacobian.row(n + 1).segment(place.turn * size, size) =
      met.row.transpose() * at->by_state.qdot / speed_unit();
  result.jacobian.col(n) = units_[0] * by_parameters.col(0);
  result.jacobian.col(n + 1).tail(2) = seen(at->by_angle);
  result.by_parameters = by_parameters.rightCols(by_parameters.cols() - 1);
  return result;
}

std::optional<double> StrobeEquations::push(const Vector& y, Parameters behind, int stop) const {
  const Eigen::Index size = map_.size();
  const System* system = systems_.at(parameters_of(y, behind));
  if (!system) return {};
  const Place place = place_of(y[y.size() - 1]);
  const auto at = map_.within(*system, y.segment(place.turn * size, size), place.angle, {});
  if (!at) return {};
  return system->stops[static_cast<std::size_t>(stop)].row.dot(at->by_angle.qdot) / speed_unit();
}

std::optional<StrobeTouch> StrobeEquations::touch_at(const Vector& y, Parameters behind,
                                                     int stop) const {
  const std::optional<double> pushed = push(y, behind, stop);
  if (!pushed) return {};
  const Place place = place_of(y[y.size() - 1]);
  return StrobeTouch{stop, static_cast<std::size_t>(place.turn), place.angle,
                     speed_unit() * std::sqrt(2.0 * kTouchDepth * std::abs(*pushed))};
}

std::optional<double> StrobeEquations::clearer_section(const BranchPoint& solution) const {
  // Far enough for a step, near enough for few moves.
  constexpr double kPart = 0.25;
  const System* system = systems_.at(solution.parameters());
  const bool none =
      !system || std::all_of(system->stops.begin(), system->stops.end(), [](const Stop& stop) {
        return stop.is_compliant() && stop.force().sets_in_smoothly();
      });
  if (none) return {};
  const std::optional<OrbitBranchPoint> at = judge(solution);
  if (!at) return {};
  std::vector<double> phases;
  for (std::size_t i = 0; i < at->orbit.impacts.size(); ++i) {
    const OrbitImpact& impact = at->orbit.impacts[i];
    const Stop& stop = system->stops[static_cast<std::size_t>(impact.stop)];
    if (stop.is_compliant() && stop.force().sets_in_smoothly()) continue;
    phases.push_back(impact.phase);
    if (stop.is_compliant())
      phases.push_back(wrapped(impact.phase + system->forcing()->frequency *
                                                  at->orbit.impacts[i].contact->duration));
  }
  if (phases.empty()) return {};
  std::sort(phases.begin(), phases.end());
  double best = 0.0, middle = 0.0, nearest = kTurn;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const double next = i + 1 < phases.size() ? phases[i + 1] : phases.front() + kTurn;
    const double ahead = wrapped(phases[i] - section());
    nearest = std::min({nearest, ahead, kTurn - ahead});
    if (next - phases[i] <= best) continue;
    best = next - phases[i];
    middle = wrapped(0.5 * (phases[i] + next));
  }
  return nearest < kPart * 0.5 * best ? std::optional(middle) : std::nullopt;
}

std::optional<BranchPoint> StrobeEquations::carried_to(const StrobeEquations& other,
                                                       const ContinuationOptions& options,
                                                       const BranchPoint& solution) const {
  const System* system = systems_.at(solution.parameters());
  const System* tangent = system ? systems_.tangent_at(solution.parameters(), 0) : nullptr;
  if (!tangent) return {};
  const double angle = wrapped(other.section() - section());
  const double range = std::abs(options.to - options.from);
  const Eigen::Index m = map_.size(), n = solution.u.size();
  BranchPoint carried = solution;
  for (Eigen::Index i = 0; i < n; i += m) {
    const std::optional<StrobeMap::Within> at =
        map_.within(*system, solution.u.segment(i, m), angle, std::span(&tangent, 1));
    if (!at) return {};
    carried.u.segment(i, m) = map_.pack(at->state);
    const Vector along = solution.tangent.segment(i, m);
    const State& moved = at->by_parameters.front();
    const double rate = solution.rate() * range;
    carried.tangent.segment(i, m) = map_.pack(
        {at->by_state.q * along + rate * moved.q, at->by_state.qdot * along + rate * moved.qdot});
  }
  return solve_near(other.problem(), options, carried.u, carried.parameter, carried.tangent);
}

}  // namespace graze
