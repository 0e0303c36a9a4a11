#include "graze/orbit/orbit_amplitudes.hpp"

#include "graze/motion/detail/amplitude_meter.hpp"
#include "graze/orbit/detail/orbit_flights.hpp"

namespace graze {

Amplitudes orbit_amplitudes(const System& system, const Orbit& orbit,
                            const std::vector<MeasuredRow>& rows) {
  AmplitudeMeter meter(system, MeasureOptions{rows});
  const FlownOrbit flown = fly_orbit(
      system, orbit, [&](const ContactPhase<double>& phase, double theta, double seconds) {
        meter.add_flight(phase, theta, 0.0, seconds);
      });
  for (const TrajectorySegment& segment : flown.segments) {
    for (const std::vector<ImpactShare<double>>& shares : segment.shares)
      meter.add_impact(shares, 0.0);
    for (const SegmentClosure& closure : segment.closures)
      meter.add_closure(closure.stops, closure.taken, 0.0);
  }
  for (const OrbitImpact& impact : orbit.impacts) {
    const Stop& stop = system.stops[static_cast<std::size_t>(impact.stop)];
    if (stop.is_compliant())
      meter.add_contact(impact.stop, 0.0);
    else if (!orbit.section)
      meter.add_impact({{impact.stop, impact.speed, 0.0,
                         (1.0 + stop.restitution().at(impact.speed)) * impact.speed, true}},
                       0.0);
  }
  return *meter.result();
}

}  // namespace graze
