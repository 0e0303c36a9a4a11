#include "graze/orbit/problem/detail/grazing_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/system/scale.hpp"

namespace graze {

std::vector<GrazingContact> grazing_contacts_near(const System& system,
                                                  const SegmentShooting& shooting,
                                                  const Vector& u) {
  const double length = motion_scale(system).length, frequency = system.forcing()->frequency;
  std::vector<std::pair<double, GrazingContact>> offered;
  const std::vector<TrajectorySegment> turns = shooting.follow(system, u, true);
  for (std::size_t turn = 0; turn < turns.size(); ++turn) {
    const TrajectorySegment& segment = turns[turn];
    Instant<double> start = segment.end.instant;
    start.period = 0;
    const auto offer = [&](double depth, int stop, const Instant<double>& at, double later) {
      const double seconds = seconds_between(system, start, at) + later;
      offered.push_back(
          {depth,
           {stop, turn, std::clamp(frequency * seconds, 0.0, kTurn * shooting.periods_each()),
            0.0}});
    };
    if (segment.lowest)
      offer(std::abs(segment.lowest->gap) / length, segment.lowest->stop, segment.lowest->at, 0.0);
    const Itinerary itinerary = itinerary_of(segment, still_speed(system));
    if (itinerary.slowest_stop >= 0 &&
        !system.stops[static_cast<std::size_t>(itinerary.slowest_stop)].is_compliant()) {
      const double part = itinerary.slowest / (frequency * length);
      offer(0.5 * part * part, itinerary.slowest_stop, itinerary.slowest_at, 0.0);
    }
    for (const SegmentContact& contact : segment.contacts) {
      if (contact.from_start) continue;
      const double part = contact.speed / (frequency * length);
      // The gap is least near its middle.
      offer(0.5 * part * part, contact.stop, contact.from,
            0.5 * seconds_between(system, contact.from, contact.to));
    }
  }
  std::stable_sort(offered.begin(), offered.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<GrazingContact> grazings;
  for (const auto& [depth, grazing] : offered) grazings.push_back(grazing);
  return grazings;
}

namespace {

// Angles nearer than this belong to one grazing contact, rad.
constexpr double kSameInstant = 1e-4;

// Whether an impact is the grazing contact, slightly deeper: the gap of the motion without the
// impact would be smallest at the grazing contact, v/a later.
bool is_of(const GrazingContact& grazing, const System& system, const SegmentImpact& impact,
           double theta, double after) {
  if (impact.stop != grazing.stop) return false;
  const Vector& row = system.stops[static_cast<std::size_t>(grazing.stop)].row;
  const double push = -row.dot(vector_field(system, impact.before, theta + after).qdot);
  if (!(push > 0.0)) return false;
  const double later = system.forcing()->frequency * impact.speed / push;
  return std::abs(after + later - grazing.angle) <= 0.5 * later + kSameInstant;
}

}  // namespace

std::optional<SegmentShooting> without_grazing(const System& system,
                                               const SegmentShooting& shooting, const Vector& u,
                                               const GrazingContact& grazing) {
  if (system.stops[static_cast<std::size_t>(grazing.stop)].is_compliant()) return shooting;
  const std::vector<TrajectorySegment> turns = shooting.follow(system, u);
  if (turns.empty()) return {};
  const TrajectorySegment& segment = turns[grazing.turn];
  const double frequency = system.forcing()->frequency, theta = shooting.theta_of(u);
  Instant<double> start = segment.end.instant;
  start.period = 0;
  double before = 0.0, after = kTurn * shooting.periods_each();
  const auto angle_of = [&](const Instant<double>& at) {
    return frequency * seconds_between(system, start, at);
  };
  const auto add = [&](double angle) {
    if (angle < grazing.angle)
      before = std::max(before, angle);
    else
      after = std::min(after, angle);
  };
  for (const SegmentImpact& impact : segment.impacts) {
    const double angle = angle_of(impact.at);
    if (!is_of(grazing, system, impact, theta, angle)) add(angle);
  }
  for (const SegmentContact& contact : segment.contacts)
    for (const Instant<double>& at : {contact.from, contact.to}) add(angle_of(at));
  for (const SegmentSticking& sticking : segment.sticking)
    for (const Instant<double>& at : {sticking.from, sticking.to}) add(angle_of(at));
  return shooting.leaving_out({grazing.stop, 0.5 * (before + grazing.angle) / frequency,
                               0.5 * (grazing.angle + after) / frequency});
}

}  // namespace graze
