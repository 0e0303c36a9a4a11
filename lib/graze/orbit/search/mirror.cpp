#include "graze/orbit/search/detail/mirror.hpp"

#include <algorithm>

#include "graze/base/angle.hpp"
#include "graze/orbit/search/detail/solved_orbit.hpp"

namespace graze {
namespace {

// Compares exactly: rows on either side of a structure come from the same shapes.
bool are_opposite(const Stop& a, const Stop& b) {
  if (a.row != -b.row || a.gap != b.gap || a.is_compliant() != b.is_compliant()) return false;
  if (a.is_compliant()) return a.force() == b.force();
  return a.direction() == -b.direction() &&
         a.restitution().coefficients() == b.restitution().coefficients();
}

// The impacts half a forcing period later, with opposite sign and stop.
std::optional<Orbit> mirrored_impacts(const System& system, const Orbit& orbit,
                                      const std::vector<int>& opposite) {
  ImpactPattern pattern = orbit.pattern();
  for (int& stop : pattern.stops) stop = opposite[static_cast<std::size_t>(stop)];
  std::vector<ImpactPoint> impacts = orbit.points();
  for (ImpactPoint& impact : impacts) {
    impact.theta += 0.5 * kTurn;
    impact.before.q *= -1.0;
    impact.before.qdot *= -1.0;
  }
  return orbit_near(system, pattern, impacts);
}

}  // namespace

std::optional<std::vector<int>> opposite_stops(const System& system) {
  if (system.load() && !system.load()->isZero(0.0)) return {};
  const auto drags = [](const Friction& friction) { return friction.speed != 0.0; };
  if (system.stops.empty() || std::any_of(system.frictions.begin(), system.frictions.end(), drags))
    return {};
  std::vector<int> opposite;
  for (const Stop& stop : system.stops) {
    std::size_t other = 0;
    while (other < system.stops.size() && !are_opposite(stop, system.stops[other])) ++other;
    if (other == system.stops.size()) return {};
    opposite.push_back(static_cast<int>(other));
  }
  return opposite;
}

std::optional<Orbit> mirrored_orbit(const System& system, const Orbit& orbit,
                                    const std::vector<int>& opposite,
                                    const SegmentOptions& options) {
  if (!orbit.section) return mirrored_impacts(system, orbit, opposite);
  const MotionState<double>& at = orbit.section->states.front();
  MotionState<double> image = at;
  image.instant = later(at.instant, 0.5 * system.period(), system.period());
  image.q *= -1.0;
  image.qdot *= -1.0;
  for (std::size_t i = opposite.size(); i < image.contacts.size(); ++i) {
    if (at.contacts[i] == Contact::kForward) image.contacts[i] = Contact::kBackward;
    if (at.contacts[i] == Contact::kBackward) image.contacts[i] = Contact::kForward;
  }
  if (image.places)
    for (double& place : *image.places) place = -place;
  for (std::size_t i = 0; i < opposite.size(); ++i) {
    const auto other = static_cast<std::size_t>(opposite[i]);
    image.contacts[other] = at.contacts[i];
    image.multiplicities[other] = at.multiplicities[i];
  }
  SegmentOptions closing = options;
  closing.closure_speed = orbit.section->closure_speed;
  if (!closed_stops(image).empty())
    return orbit_through(system, image, orbit.period, closing).orbit;
  const TrajectorySegment segment = pass(system, image, {image.instant.period + 1, 0.0}, closing);
  if (!segment.failure.empty()) return {};
  return followed_orbit(system, {segment.end.q, segment.end.qdot}, orbit.period, closing).orbit;
}

}  // namespace graze
