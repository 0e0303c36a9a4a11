#include "graze/orbit/orbit_curve.hpp"

#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/flow/exact_flow.hpp"

namespace graze {

std::vector<std::vector<CurveSample>> orbit_curve(const System& system, const Orbit& orbit,
                                                  int stop, int per_period) {
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  const Vector& row = system.stops[static_cast<std::size_t>(stop)].row;
  const std::vector<ImpactPoint> points = orbit.points();
  std::vector<std::vector<CurveSample>> flights;
  Vector q(system.modes()), qdot(system.modes());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double next =
        i + 1 < points.size() ? points[i + 1].theta : points.front().theta + kTurn * orbit.period;
    const auto hit = static_cast<std::size_t>(orbit.impacts[i].stop);
    const State after = after_impact(system.stops[hit], points[i].before);
    arc.start(points[i].theta, after.q, after.qdot);
    const double turn = next - points[i].theta;
    const int count = std::max(1, static_cast<int>(std::ceil(turn / kTurn * per_period)));
    std::vector<CurveSample> flight;
    for (int k = 0; k <= count; ++k) {
      const double phase = turn * k / count;
      arc.state(phase / flow.frequency(), q, qdot);
      flight.push_back({points[i].theta + phase, row.dot(q), row.dot(qdot)});
    }
    flights.push_back(std::move(flight));
  }
  return flights;
}

}  // namespace graze
