#include "graze/orbit/detail/orbit_curve.hpp"

#include <algorithm>
#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/orbit/detail/orbit_flights.hpp"

namespace graze {
namespace {

// The arcs of a whole orbit, some of which begin at an impact, as flights that all do; `whole`: its
// periods, rad. Every flight begins within them, the one of the smallest phase first.
std::vector<std::vector<CurveSample>> from_impact_to_impact(
    const std::vector<std::vector<CurveSample>>& arcs, const std::vector<bool>& begins_at_impact,
    double whole) {
  std::vector<std::vector<CurveSample>> flights;
  std::vector<CurveSample> head;  // up to the first impact: the end of the last flight
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (begins_at_impact[i]) flights.emplace_back();
    std::vector<CurveSample>& into = flights.empty() ? head : flights.back();
    into.insert(into.end(), arcs[i].begin(), arcs[i].end());
  }
  if (flights.empty()) return {head};
  for (CurveSample& sample : head) {
    sample.theta += whole;
    flights.back().push_back(sample);
  }
  for (std::vector<CurveSample>& flight : flights) {
    const double turn = whole * std::floor(flight.front().theta / whole);
    for (CurveSample& sample : flight) sample.theta -= turn;
  }
  const auto first = std::min_element(
      flights.begin(), flights.end(),
      [](const auto& a, const auto& b) { return a.front().theta < b.front().theta; });
  std::rotate(flights.begin(), first, flights.end());
  return flights;
}

}  // namespace

std::vector<std::vector<CurveSample>> orbit_curve(const System& system, const Orbit& orbit,
                                                  const Vector& row, int per_period) {
  const double frequency = system.forcing()->frequency;
  // The hops of a chatter are short and still curves, and so are contacts.
  const double least = orbit.section ? 12.0 : 1.0;
  State state{Vector(system.modes()), Vector(system.modes())};
  std::vector<std::vector<CurveSample>> flights;
  OrbitListeners listeners;
  listeners.flight = [&](const ContactPhase<double>& phase, double theta, double seconds) {
    const double turn = frequency * seconds;
    const int count = static_cast<int>(std::fmax(least, std::ceil(turn / kTurn * per_period)));
    flights.emplace_back();
    for (int k = 0; k <= count; ++k) {
      phase.state(seconds * k / count, state.q, state.qdot);
      flights.back().push_back({theta + turn * k / count, row.dot(state.q), row.dot(state.qdot)});
    }
  };
  const std::vector<bool> begins_at_impact = fly_orbit(system, orbit, listeners);
  return from_impact_to_impact(flights, begins_at_impact, kTurn * orbit.period);
}

}  // namespace graze
