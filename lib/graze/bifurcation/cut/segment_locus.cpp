#include "graze/bifurcation/cut/detail/segment_locus.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "graze/orbit/problem/detail/segment_events.hpp"

namespace graze {
namespace {

// Largest number of points of a locus of orbits that stick, in each direction: beside a grazing
// steps may shrink with the speed of an impact, without end.
constexpr int kMostLocusPoints = 1000;
// Tolerance on CH, which is computed from impacts whose speeds have relative errors of some 1e-5.
constexpr double kCompletion = 1e-9;
// The speed of a new impact grows at most with the root of the distance to its grazing: its value
// within the bracket, in units of speed, with some room.
constexpr double kBorn = 1e-2;
// When an impact is this slow, in units of speed, the grazing is some 1e-5 of the range away, and
// steps are shorter than that.
constexpr double kSlowOnLocus = 5e-3;

std::vector<int> sticking_of(const Itinerary& itinerary) {
  std::vector<int> sticking;
  std::ranges::copy_if(itinerary.events, std::back_inserter(sticking),
                       [](int event) { return event < 0; });
  return sticking;
}

LocusPlace as_place(const LocusSite& at, const Orbit& orbit) {
  return {{at.first, at.second, at.angle, orbit.impacts, true, orbit.sticking, orbit.section},
          Vector(),
          "",
          {}};
}

}  // namespace

std::optional<LocusPlace> FixedPhaseLocus::place(const LocusSite& at,
                                                 std::optional<LocusMargin> /*zero*/) const {
  if (const auto kept = kept_.find(unknowns_of(at)); kept != kept_.end()) return kept->second;
  const System* system = system_at(at);
  const std::optional<Orbit> orbit =
      system ? orbit_of(*system, equations_.shooting(), at.u, {}) : std::nullopt;
  return orbit ? std::optional(as_place(at, *orbit)) : std::nullopt;
}

FixedPhaseLocus::Unknowns FixedPhaseLocus::unknowns_of(const LocusSite& at) {
  Unknowns unknowns{at.first, at.second};
  unknowns.insert(unknowns.end(), at.u.begin(), at.u.end());
  return unknowns;
}

bool FixedPhaseLocus::keep(const LocusSite& at) const {
  std::optional<LocusPlace> there = place(at, {});
  if (!there) return false;
  kept_.emplace(unknowns_of(at), std::move(*there));
  return true;
}

// Contacts may be born and lost along it: those of its first point give the pattern.
ImpactPattern FixedPhaseLocus::pattern(const std::vector<LocusPlace>& places) const {
  ImpactPattern pattern{equations_.period(), {}};
  if (places.empty()) return pattern;
  const OrbitLocusPoint& first = places.front().at;
  for (const StickingPhase& sticking : first.sticking) pattern.stops.push_back(sticking.stop);
  if (first.sticking.empty())
    for (const OrbitImpact& impact : first.impacts) pattern.stops.push_back(impact.stop);
  return pattern;
}

ReleaseLocus::ReleaseLocus(const SegmentEquations& equations, bool completing)
    : FixedPhaseLocus(equations), completing_(completing) {
  if (completing) tolerance = kCompletion;
  most_points = kMostLocusPoints;
}

std::optional<ReleaseReturn> ReleaseLocus::return_at(const LocusSite& at, bool minima) const {
  const System* system = system_at(at);
  const auto shooting = system ? shooting_at(at) : std::nullopt;
  std::optional<ReleaseReturn> back =
      shooting ? return_of(*system, *shooting, at.u, minima) : std::nullopt;
  if (!back || back->returns || !completing_) return back;
  const Instant<double>& end = back->segment.end.instant;
  back->segment.sticking.push_back(
      {*equations_.layout().released, end, end, false, false, 0.0, {}});
  back->itinerary = itinerary_of(back->segment, still_speed(*system));
  back->returns = true;
  return back;
}

std::optional<Itinerary> ReleaseLocus::itinerary_at(const LocusSite& at) const {
  const std::optional<ReleaseReturn> back = return_at(at, false);
  return back && back->returns ? std::optional(back->itinerary) : std::nullopt;
}

// GR where an impact outside the chatters is born or lost, or has nearly lost its speed.
std::optional<OrbitLocusEnd> ReleaseLocus::change(const LocusSite& a, const LocusSite& b) const {
  const std::optional<Itinerary> before = itinerary_at(a), now = itinerary_at(b);
  if (!before || !now)
    return completing_ ? OrbitLocusEnd::kNotConverged : OrbitLocusEnd::kChatterCompletes;
  if (sticking_of(*before) != sticking_of(*now)) return OrbitLocusEnd::kChatterCompletes;
  const double speed = equations_.speed_unit();
  const bool born = now->events.size() > before->events.size();
  const bool grazes = before->events == now->events
                          ? now->slowest <= kSlowOnLocus * speed && now->slowest < before->slowest
                          : (born ? now : before)->slowest <= kBorn * speed;
  return grazes ? std::optional(OrbitLocusEnd::kGrazing) : std::nullopt;
}

bool ReleaseLocus::goes_on(const LocusSite& previous, const LocusSite& here) const {
  return !change(previous, here);
}

OrbitLocusEnd ReleaseLocus::end_between(const LocusSite& inner, const LocusSite& outer) const {
  return change(inner, outer).value_or(OrbitLocusEnd::kNotConverged);
}

bool ReleaseLocus::resolves(const LocusSite& from, const LocusSite& to) const {
  const double first = (to.first - from.first) / equations_.unit(0),
               second = (to.second - from.second) / equations_.unit(1);
  if ((to.u - from.u).norm() + std::hypot(first, second) <= kLocusBracket) return true;
  const std::optional<Itinerary> before = itinerary_at(from), now = itinerary_at(to);
  return before && now && before->events == now->events;
}

// GR when an approach touches there, or an impact has lost its speed.
OrbitLocusEnd ReleaseLocus::end_at(const LocusSite& last) const {
  const std::optional<ReleaseReturn> back = return_at(last, true);
  if (!back) return OrbitLocusEnd::kNotConverged;
  const MotionScale scale = motion_scale(*system_at(last));
  const std::optional<double> clearance = back->segment.clearance();
  const bool grazes = back->itinerary.slowest <= kBorn * scale.speed ||
                      (clearance && *clearance <= kLocusBracket * scale.length);
  return grazes ? OrbitLocusEnd::kGrazing : OrbitLocusEnd::kNotConverged;
}

std::optional<LocusPlace> ReleaseLocus::place(const LocusSite& at,
                                              std::optional<LocusMargin> zero) const {
  return completing_ ? place_at_release(at, {}) : FixedPhaseLocus::place(at, zero);
}

std::optional<LocusPlace> ReleaseLocus::place_at_release(
    const LocusSite& at, const std::optional<GrazingContact>& grazing) const {
  const System* system = system_at(at);
  const auto shooting = system ? shooting_at(at) : std::nullopt;
  if (!shooting) return {};
  const SectionMap& map = shooting->map();
  const Vector x = shooting->at_section(at.u, 0);
  const double theta = shooting->theta_of(at.u);
  const auto start = map.start_of(*system, x, theta);
  const std::optional<ReleaseReturn> back = return_at(at, true);
  if (!start || !back) return {};
  std::optional<MetGrazing> met;
  if (grazing) {
    const auto there = map.within(*system, x, theta, grazing->angle, false, {});
    if (!there) return {};
    met = MetGrazing{*grazing, there->at.instant, there->state};
  }
  const std::vector<TrajectorySegment> segments{back->segment};
  Orbit orbit;
  orbit.period = equations_.period();
  orbit.section = OrbitSection{{}, {*start}, map.options().closure_speed};
  add_events(*system, segments, orbit.period, met, orbit);
  return orbit.impacts.empty() ? std::nullopt : std::optional(as_place(at, orbit));
}

}  // namespace graze
