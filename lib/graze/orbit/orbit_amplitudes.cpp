#include "graze/orbit/orbit_amplitudes.hpp"

#include "graze/motion/detail/amplitude_meter.hpp"
#include "graze/orbit/detail/orbit_curve.hpp"

namespace graze {

Amplitudes orbit_amplitudes(const System& system, const Orbit& orbit,
                            const std::vector<MeasuredRow>& rows) {
  AmplitudeMeter meter(system, MeasureOptions{rows});
  OrbitListeners listeners;
  listeners.flight = [&](const ContactPhase<double>& phase, double theta, double seconds) {
    meter.add_flight(phase, theta, 0.0, seconds);
  };
  listeners.impact = [&](const std::vector<ImpactShare<double>>& shares) {
    meter.add_impact(shares, 0.0);
  };
  listeners.closure = [&](const std::vector<int>& stops, const Vector& taken) {
    meter.add_closure(stops, taken, 0.0);
  };
  fly_orbit(system, orbit, listeners);
  for (const OrbitImpact& impact : orbit.impacts)
    if (system.stops[static_cast<std::size_t>(impact.stop)].is_compliant())
      meter.add_contact(impact.stop, 0.0);
  return *meter.result();
}

}  // namespace graze
