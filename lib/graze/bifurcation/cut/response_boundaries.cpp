#include "graze/bifurcation/cut/detail/response_boundaries.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/base/detail/bracketed_zero.hpp"

namespace graze {

bool ResponseBoundaries::lists(const SolutionPoint& solution) const {
  const std::optional<OrbitBranchPoint> at = equations_.judge(solution);
  return at && (branches_.keep_virtual || at->orbit.admissible);
}

std::optional<ResponseBoundaries::Clearance> ResponseBoundaries::clearance(std::size_t stop,
                                                                           double value) const {
  const System* system = equations_.system_at(value);
  const System* tangent =
      system ? equations_.tangent_at(std::span<const double>(&value, 1)) : nullptr;
  const std::optional<Response> response = tangent ? response_of(*system) : std::nullopt;
  if (!response) return {};
  const Stop &at = system->stops[stop], &moved = tangent->stops[stop];
  const Response rate = response_rate(*system, *tangent, *response);
  if (!response->harmonics.empty()) {
    const double nearest = response->nearest_phase(at);
    return Clearance{response->clearance(at), moved.gap -
                                                  moved.row.dot(response->at(nearest, 1.0).q) -
                                                  at.row.dot(rate.at(nearest, 1.0).q)};
  }
  const Complex swing = at.row.dot(response->amplitude);
  const Complex turning = at.row.dot(rate.amplitude) + moved.row.dot(response->amplitude);
  const double size = std::abs(swing);
  return Clearance{response->clearance(at),
                   moved.gap - moved.row.dot(response->offset) - at.row.dot(rate.offset) -
                       (size > 0.0 ? (std::conj(swing) * turning).real() / size : 0.0)};
}

std::vector<double> ResponseBoundaries::touched(std::size_t stop, double from, double to) const {
  const auto value_at = [&](double value) {
    const auto at = clearance(stop, value);
    return at ? at->value : 0.0;
  };
  const auto rate_at = [&](double value) {
    const auto at = clearance(stop, value);
    return at ? at->rate : 0.0;
  };
  std::vector<double> ends{from};
  const double before = rate_at(from), after = rate_at(to);
  if (before * after < 0.0)
    ends.push_back(bracketed_zero(rate_at, {from, before}, {to, after}).first);
  ends.push_back(to);
  std::vector<double> places;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double here = value_at(ends[i]), next = value_at(ends[i + 1]);
    if (here * next < 0.0)
      places.push_back(bracketed_zero(value_at, {ends[i], here}, {ends[i + 1], next}).first);
  }
  return places;
}

std::optional<BranchPlace> ResponseBoundaries::grazing(double value) const {
  const std::optional<Vector> u = equations_.unknowns_at({&value, 1});
  std::optional<SolutionPoint> point =
      u ? solve_at(equations_.problem(), options_, *u, value) : std::nullopt;
  if (!point) return {};
  point->bracket = bracket_around({value}, true);
  std::optional<OrbitBranchPoint> at = equations_.judge(*point);
  if (!at) return {};
  // It touches and does not cross; the side on which the last bit falls has no meaning.
  at->orbit.admissible = true;
  BranchPlace place{*at, {}, true, OrbitBranchEnd::kGrazing};
  place.special = SpecialPoint{SpecialKind::kGrazing, "", std::move(*at), {}, false, *point};
  return place;
}

bool ResponseBoundaries::is_clear(double value) const {
  const System* system = equations_.system_at(value);
  const std::optional<Response> response = system ? response_of(*system) : std::nullopt;
  return response && response->clearance(system->stops).value_or(0.0) >= 0.0;
}

// A touch of a stop is a boundary where the motion is clear of all stops on one side of it only.
// Where several stops are touched within rounding of each other, one of the touches is the
// boundary, whatever the rounded motion between them.
void ResponseBoundaries::pass(const JudgedPoint& a, const JudgedPoint& b,
                              std::vector<BranchPlace>& places) {
  const double from = std::min(a.point.parameter, b.point.parameter);
  const double to = std::max(a.point.parameter, b.point.parameter);
  const System* system = equations_.system_at(from);
  if (!system || !(from < to)) return;
  const std::size_t stops = system->stops.size();
  std::vector<double> values;
  for (std::size_t stop = 0; stop < stops; ++stop)
    for (const double value : touched(stop, from, to)) values.push_back(value);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  std::vector<bool> clear;  // below the first, between them, above the last
  for (std::size_t i = 0; i <= values.size(); ++i) {
    const double low = i == 0 ? from : values[i - 1], high = i == values.size() ? to : values[i];
    clear.push_back(is_clear(low + 0.5 * (high - low)));
  }
  const bool falls = a.point.parameter > b.point.parameter;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::size_t i = falls ? values.size() - 1 - k : k;
    if (clear[i] == clear[i + 1]) continue;
    std::optional<BranchPlace> place = grazing(values[i]);
    if (!place) continue;
    // With virtual solutions listed on either side, nothing ends.
    place->begins = clear[falls ? i : i + 1] && !branches_.keep_virtual;
    places.push_back(std::move(*place));
  }
}

}  // namespace graze
