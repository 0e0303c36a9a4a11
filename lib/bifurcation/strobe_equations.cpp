#include "graze/bifurcation/strobe_equations.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/half_period.hpp"
#include "graze/orbit/solve.hpp"

namespace graze {

StrobeEquations::StrobeEquations(const SystemFamily& family, const StrobeOptions& options,
                                 int period)
    : systems_(family),
      map_(*family.at(family.value()), options),
      length_(motion_scale(*family.at(family.value())).length),
      period_(period) {
  problem_ =
      periodic_points([this](const Vector& x, double value) { return evaluate(x, value); }, period);
}

std::optional<MapEvaluation> StrobeEquations::evaluate(const Vector& x, double value) const {
  const System* system = systems_.at(value);
  const System* tangent = systems_.tangent_at(value);
  if (!system || !tangent) return {};
  std::optional<StrobeMap::Image> image = map_.image(*system, x, tangent);
  if (!image) return {};
  return MapEvaluation{std::move(image->image), std::move(image->jacobian),
                       std::move(image->by_parameter)};
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
    const System* system = systems_.at(solution.parameter);
    if (!system) return {};
    std::vector<Eigenvalue> multipliers = solution.multipliers;
    if (multipliers.empty())
      multipliers = problem_.multipliers(solution.u, solution.parameter, ErrorBounds::kGiven);
    std::optional<Orbit> orbit =
        orbit_of(*system, map_, solution.u, std::move(multipliers), solution.residual);
    if (!orbit) return {};
    return point_of_branch(solution.parameter, std::move(*orbit));
  });
}

std::optional<OrbitBranchPoint> StrobeEquations::judge_touching(const BranchPoint& solution,
                                                                const StrobeTouch& touch) const {
  const System* system = systems_.at(solution.parameter);
  if (!system) return {};
  std::optional<Orbit> orbit =
      touching_orbit_of(*system, map_, solution.u, touch, solution.residual);
  if (!orbit) return {};
  orbit->multipliers = problem_.multipliers(solution.u, solution.parameter, ErrorBounds::kGiven);
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
  const System* system = systems_.at(solution.parameter);
  const std::optional<Orbit> orbit =
      system ? orbit_of(*system, map_, solution.u, {}, solution.residual) : std::nullopt;
  if (!orbit) return {};
  std::vector<int> stops = orbit->pattern().stops;
  std::sort(stops.begin(), stops.end());
  return stops;
}

std::vector<StrobeTouch> StrobeEquations::touches_near(const BranchPoint& solution) const {
  const System* system = systems_.at(solution.parameter);
  if (!system) return {};
  std::vector<StrobeTouch> touches = graze::touches_near(*system, map_, solution.u);
  std::erase_if(touches, [&](const StrobeTouch& touch) {
    return !system->stops[static_cast<std::size_t>(touch.stop)].is_compliant();
  });
  return touches;
}

bool StrobeEquations::sets_in_smoothly(const BranchPoint& solution, int stop) const {
  const System* system = systems_.at(solution.parameter);
  const Stop* met = system ? &system->stops[static_cast<std::size_t>(stop)] : nullptr;
  return met && met->is_compliant() && met->force().sets_in_smoothly();
}

std::optional<StrobeEquations::Touching> StrobeEquations::touching(const Vector& x, double value,
                                                                   double angle, int stop) const {
  const System* system = systems_.at(value);
  const System* tangent = system ? systems_.tangent_at(value) : nullptr;
  if (!tangent) return {};
  const std::optional<StrobeMap::Within> at =
      map_.within(*system, x, angle, std::span(&tangent, 1));
  if (!at) return {};
  const auto index = static_cast<std::size_t>(stop);
  const Stop &met = system->stops[index], &rate = tangent->stops[index];
  const double speed = length_ * system->forcing()->frequency;
  const State& moved = at->by_parameters.front();
  Touching touching;
  touching.by_state.resize(2, map_.size());
  touching.value << (met.row.dot(at->state.q) - met.gap) / length_,
      met.row.dot(at->state.qdot) / speed;
  touching.by_state.row(0) = met.row.transpose() * at->by_state.q / length_;
  touching.by_state.row(1) = met.row.transpose() * at->by_state.qdot / speed;
  touching.by_angle << met.row.dot(at->by_angle.q) / length_,
      met.row.dot(at->by_angle.qdot) / speed;
  touching.by_parameter << (met.row.dot(moved.q) + rate.row.dot(at->state.q) - rate.gap) / length_,
      (met.row.dot(moved.qdot) + rate.row.dot(at->state.qdot)) / speed;
  touching.push = touching.by_angle[1];
  return touching;
}

std::optional<double> StrobeEquations::clearer_section(const BranchPoint& solution) const {
  // Far enough for a step, near enough for few moves.
  constexpr double kPart = 0.25;
  const System* system = systems_.at(solution.parameter);
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
  const System* system = systems_.at(solution.parameter);
  const System* tangent = system ? systems_.tangent_at(solution.parameter) : nullptr;
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
