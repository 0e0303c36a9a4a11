// Grazing contacts in the equations of followed orbits.
#include <algorithm>
#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/problem/detail/segment_equations.hpp"

namespace graze {

std::optional<OrbitBranchPoint> SegmentEquations::judge_grazing(
    const SolutionPoint& solution, const GrazingContact& grazing) const {
  const System* system = system_at(solution.parameters());
  if (!system) return {};
  std::optional<Orbit> orbit =
      orbit_of(*system, shooting_, solution.u,
               shooting_.multipliers(*system, solution.u, ErrorBounds::kGiven), grazing);
  if (!orbit) return {};
  return point_of_branch(solution.parameter, std::move(*orbit));
}

std::optional<OrbitBranchPoint> SegmentEquations::judge_without(
    const SolutionPoint& solution, const GrazingContact& grazing) const {
  std::optional<OrbitBranchPoint> at = judge_grazing(solution, grazing);
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

std::vector<GrazingContact> SegmentEquations::grazing_contacts_near(
    const SolutionPoint& solution) const {
  const System* system = system_at(solution.parameters());
  if (!system) return {};
  std::vector<GrazingContact> grazings =
      graze::grazing_contacts_near(*system, shooting_, solution.u);
  std::erase_if(grazings, [&](const GrazingContact& grazing) {
    return !system->stops[static_cast<std::size_t>(grazing.stop)].is_compliant();
  });
  return grazings;
}

// A section at a release lies at the phase u[0], and one segment covers the whole orbit.
SegmentEquations::Place SegmentEquations::place_of(const Vector& y) const {
  const double psi = y[y.size() - 1];
  if (layout().released) {
    const double all = kTurn * period(), angle = psi - y[0];
    return {0, angle - all * std::floor(angle / all)};
  }
  const double whole = std::floor(psi / kTurn);
  const Eigen::Index turn = static_cast<Eigen::Index>(whole) % period();
  return {turn < 0 ? turn + period() : turn, std::clamp(psi - whole * kTurn, 0.0, kTurn)};
}

double SegmentEquations::psi_of(const Vector& u, const GrazingContact& grazing) const {
  return (layout().released ? u[0] : 0.0) + static_cast<double>(grazing.turn) * kTurn +
         grazing.angle;
}

std::vector<double> SegmentEquations::parameters_of(const Vector& y, Parameters behind) const {
  std::vector<double> all{y[y.size() - 2] * units_[0]};
  all.insert(all.end(), behind.begin(), behind.end());
  return all;
}

std::optional<SegmentShooting> SegmentEquations::without_grazing(const Vector& y, Parameters all,
                                                                 int stop) const {
  const System* system = system_at(all);
  const Place place = place_of(y);
  const GrazingContact grazing{stop, static_cast<std::size_t>(place.turn), place.angle, 0.0};
  return system ? graze::without_grazing(*system, shooting_, y.head(y.size() - 2), grazing)
                : std::nullopt;
}

std::optional<SectionMap::Within> SegmentEquations::within(
    const SegmentShooting& shooting, const Vector& y, const System& system,
    std::span<const System* const> tangents) const {
  const Place place = place_of(y);
  return shooting.map().within(system, shooting.at_section(y, static_cast<int>(place.turn)),
                               shooting.theta_of(y), place.angle, layout().released.has_value(),
                               tangents);
}

std::optional<ZeroEvaluation> SegmentEquations::grazing(const Vector& y, Parameters behind,
                                                        int stop) const {
  const Eigen::Index n = y.size() - 2, size = map().size();
  const std::vector<double> parameters = parameters_of(y, behind);
  const std::optional<SegmentShooting> shooting = without_grazing(y, parameters, stop);
  const std::vector<const System*> tangents = tangents_at(parameters);
  if (!shooting || tangents.empty()) return {};
  const System& system = *system_at(parameters);
  const std::optional<ShootingLinearisation> orbit =
      shooting->linearise(system, y.head(n), tangents);
  const auto at = orbit ? within(*shooting, y, system, tangents) : std::nullopt;
  if (!at) return {};
  const auto index = static_cast<std::size_t>(stop);
  const Stop& met = system.stops[index];
  // Gap and approach speed of a state's rate, in units of depths and speeds.
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
  if (shooting->head() > 0) result.jacobian.col(0).tail(2) = seen(at->by_start);
  const Eigen::Index first = shooting->head() + place_of(y).turn * size;
  result.jacobian.row(n).segment(first, size) = met.row.transpose() * at->by_state.q / length();
  result.jacobian.row(n + 1).segment(first, size) =
      met.row.transpose() * at->by_state.qdot / speed_unit();
  result.jacobian.col(n) = units_[0] * by_parameters.col(0);
  result.jacobian.col(n + 1).tail(2) = seen(at->by_angle);
  result.by_parameters = by_parameters.rightCols(by_parameters.cols() - 1);
  return result;
}

std::optional<double> SegmentEquations::push(const Vector& y, Parameters behind, int stop) const {
  const std::vector<double> all = parameters_of(y, behind);
  const std::optional<SegmentShooting> shooting = without_grazing(y, all, stop);
  const auto at = shooting ? within(*shooting, y, *system_at(all), {}) : std::nullopt;
  if (!at) return {};
  return system_at(all)->stops[static_cast<std::size_t>(stop)].row.dot(at->by_angle.qdot) /
         speed_unit();
}

std::optional<GrazingContact> SegmentEquations::grazing_at(const Vector& y, Parameters behind,
                                                           int stop) const {
  const std::optional<double> pushed = push(y, behind, stop);
  if (!pushed) return {};
  const Place place = place_of(y);
  return GrazingContact{stop, static_cast<std::size_t>(place.turn), place.angle,
                        speed_unit() * std::sqrt(2.0 * kGrazingDepth * std::abs(*pushed))};
}

}  // namespace graze
