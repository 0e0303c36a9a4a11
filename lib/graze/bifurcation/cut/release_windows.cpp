#include "graze/bifurcation/cut/detail/release_windows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/orbit/problem/detail/chatter_completion.hpp"
#include "graze/orbit/problem/detail/passage_events.hpp"

namespace graze {
namespace {

constexpr int kWindows = 6;
// Places looked at in each: a solution there may be one of the next window.
constexpr int kLooks = 2;
// How far from CH the first one is sought, of the range.
constexpr double kFirst = 0.02;

// A motion from the release that does not come back to rest, as impacts and flights.
std::optional<Orbit> impacts_of(const System& system, const PassageEquations& equations,
                                const SolutionPoint& solution) {
  std::optional<ReleaseReturn> back = equations.follow(solution);
  if (!back || back->returns || !back->holds.empty()) return {};
  Orbit orbit;
  orbit.period = equations.period();
  orbit.section.emplace().states = {back->passage.end};
  back->passage.holds.clear();
  add_events(system, {back->passage}, orbit.period, {}, orbit);
  orbit.section.reset();
  return orbit.impacts.empty() ? std::nullopt : std::optional(std::move(orbit));
}

}  // namespace

std::vector<OrbitBranchPoint> windows_beyond(const PassageEquations& equations,
                                             const ContinuationOptions& options,
                                             const SolutionPoint& border,
                                             const SolutionPoint& outer) {
  std::vector<OrbitBranchPoint> list;
  const auto released = static_cast<std::size_t>(*equations.layout().released);
  const Stop& stop = equations.system_at(border.parameter)->stops[released];
  // By what part a window is narrower than the one before it. Without restitution the impact that
  // ends a flight is the only one.
  const double crowding = parting_ratio(stop.restitution().at_rest());
  if (!std::isfinite(crowding)) return list;
  const double closer = std::pow(crowding, 1.0 / kLooks);
  const double step = outer.parameter - border.parameter;
  double part = std::max(1.0, kFirst * std::abs((options.to - options.from) / step));
  for (int look = 0; look < kLooks * kWindows; ++look, part /= closer) {
    const double value = border.parameter + part * step;
    if (value < std::min(options.from, options.to) || value > std::max(options.from, options.to))
      continue;
    const Vector guess = border.u + part * (outer.u - border.u);
    const auto solution = solve_at(equations.problem(), options, guess, value);
    const System* system = solution ? equations.system_at(value) : nullptr;
    if (!system) continue;
    if (std::optional<Orbit> orbit = impacts_of(*system, equations, *solution))
      list.push_back(point_of_branch(value, std::move(*orbit)));
  }
  return list;
}

}  // namespace graze
