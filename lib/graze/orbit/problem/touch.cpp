#include "graze/orbit/problem/detail/touch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/system/scale.hpp"

namespace graze {

std::vector<Touch> touches_near(const System& system, const PassageShooting& shooting,
                                const Vector& u) {
  const double length = motion_scale(system).length, frequency = system.forcing()->frequency;
  std::vector<std::pair<double, Touch>> offered;
  const std::vector<Passage> turns = shooting.follow(system, u, true);
  for (std::size_t turn = 0; turn < turns.size(); ++turn) {
    const Passage& passage = turns[turn];
    Instant<double> start = passage.end.instant;
    start.period = 0;
    const auto offer = [&](double depth, int stop, const Instant<double>& at, double later) {
      const double seconds = seconds_between(system, start, at) + later;
      offered.push_back(
          {depth,
           {stop, turn, std::clamp(frequency * seconds, 0.0, kTurn * shooting.periods_each()),
            0.0}});
    };
    if (passage.lowest)
      offer(std::abs(passage.lowest->gap) / length, passage.lowest->stop, passage.lowest->at, 0.0);
    const Itinerary itinerary = itinerary_of(passage, still_speed(system));
    if (itinerary.slowest_stop >= 0 &&
        !system.stops[static_cast<std::size_t>(itinerary.slowest_stop)].is_compliant()) {
      const double part = itinerary.slowest / (frequency * length);
      offer(0.5 * part * part, itinerary.slowest_stop, itinerary.slowest_at, 0.0);
    }
    for (const PassedContact& contact : passage.contacts) {
      if (contact.from_start) continue;
      const double part = contact.speed / (frequency * length);
      // The gap is least near its middle.
      offer(0.5 * part * part, contact.stop, contact.from,
            0.5 * seconds_between(system, contact.from, contact.to));
    }
  }
  std::stable_sort(offered.begin(), offered.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Touch> touches;
  for (const auto& [depth, touch] : offered) touches.push_back(touch);
  return touches;
}

namespace {

// Angles nearer than this are those of one touch, rad.
constexpr double kSameInstant = 1e-4;

// Whether an impact is what the touch comes to a little deeper: the gap of the motion without it
// would be least at the touch, v/a later.
bool is_of(const Touch& touch, const System& system, const PassedImpact& impact, double theta,
           double after) {
  if (impact.stop != touch.stop) return false;
  const Vector& row = system.stops[static_cast<std::size_t>(touch.stop)].row;
  const double push = -row.dot(vector_field(system, impact.before, theta + after).qdot);
  if (!(push > 0.0)) return false;
  const double later = system.forcing()->frequency * impact.speed / push;
  return std::abs(after + later - touch.angle) <= 0.5 * later + kSameInstant;
}

}  // namespace

std::optional<PassageShooting> without_touch(const System& system, const PassageShooting& shooting,
                                             const Vector& u, const Touch& touch) {
  if (system.stops[static_cast<std::size_t>(touch.stop)].is_compliant()) return shooting;
  const std::vector<Passage> turns = shooting.follow(system, u);
  if (turns.empty()) return {};
  const Passage& passage = turns[touch.turn];
  const double frequency = system.forcing()->frequency, theta = shooting.theta_of(u);
  Instant<double> start = passage.end.instant;
  start.period = 0;
  double before = 0.0, after = kTurn * shooting.periods_each();
  const auto angle_of = [&](const Instant<double>& at) {
    return frequency * seconds_between(system, start, at);
  };
  const auto add = [&](double angle) {
    if (angle < touch.angle)
      before = std::max(before, angle);
    else
      after = std::min(after, angle);
  };
  for (const PassedImpact& impact : passage.impacts) {
    const double angle = angle_of(impact.at);
    if (!is_of(touch, system, impact, theta, angle)) add(angle);
  }
  for (const PassedContact& contact : passage.contacts)
    for (const Instant<double>& at : {contact.from, contact.to}) add(angle_of(at));
  for (const PassedHold& hold : passage.holds)
    for (const Instant<double>& at : {hold.from, hold.to}) add(angle_of(at));
  return shooting.leaving_out({touch.stop, 0.5 * (before + touch.angle) / frequency,
                               0.5 * (touch.angle + after) / frequency});
}

}  // namespace graze
