#include "graze/orbit/problem/detail/followed_orbit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/orbit/problem/detail/polish.hpp"
#include "graze/orbit/problem/detail/release.hpp"
#include "graze/orbit/problem/detail/segment_events.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// Largest entry of the difference between the end and the start of the motion, in units of the
// forced motion: of the whole state, stuck or not.
double whole_residual(const System& system, const std::vector<MotionState<double>>& starts,
                      const std::vector<TrajectorySegment>& segments) {
  const MotionScale scale = motion_scale(system);
  double largest = 0.0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const MotionState<double>&end = segments[i].end, &next = starts[(i + 1) % starts.size()];
    largest =
        std::max({largest, (end.q - next.q).cwiseAbs().maxCoeff() / scale.displacement,
                  (end.qdot - next.qdot).cwiseQuotient(scale.velocity).cwiseAbs().maxCoeff()});
  }
  return largest;
}

// Starts of motions that repeat the orbit: on the sections within a stuck phase, else at the starts
// of the forcing periods. Empty where one cannot be followed so far.
std::vector<MotionState<double>> section_states(const System& system,
                                                const SegmentShooting& shooting, const Vector& u,
                                                const std::vector<MotionState<double>>& starts) {
  const double theta = shooting.theta_of(u), angle = wrapped(-theta);
  if (!shooting.layout().closed.empty() || angle == 0.0) return starts;
  std::vector<MotionState<double>> states;
  for (int i = 0; i < shooting.layout().sections; ++i) {
    auto within = shooting.map().within(system, shooting.at_section(u, i), theta, angle, false, {});
    if (!within) return {};
    states.push_back(std::move(within->at));
  }
  return states;
}

std::vector<MotionState<double>> starts_of(const System& system, const SegmentShooting& shooting,
                                           const Vector& u) {
  std::vector<MotionState<double>> starts;
  for (int i = 0; i < shooting.layout().sections; ++i) {
    auto start = shooting.map().start_of(system, shooting.at_section(u, i), shooting.theta_of(u));
    if (!start) return {};
    starts.push_back(std::move(*start));
  }
  return starts;
}

// Whether some friction slides one way for ever.
bool slides_on(const MotionState<double>& at) {
  return std::any_of(at.contacts.begin(), at.contacts.end(), [](Contact contact) {
    return contact == Contact::kForward || contact == Contact::kBackward;
  });
}

struct Equations {
  Vector residual;
  Matrix jacobian;
  std::vector<Matrix> slopes;  // of the segments
};

std::optional<Polished<Equations>> newton(const System& system, const SegmentShooting& shooting,
                                          const Vector& u) {
  return polish(u, [&](const Vector& at) -> std::optional<Equations> {
    Equations equations;
    auto sum = shooting.linearise(system, at, {}, &equations.slopes);
    if (!sum) return {};
    equations.residual = std::move(sum->residual);
    equations.jacobian = std::move(sum->jacobian);
    return equations;
  });
}

// The first shorter period after which the motion of a solution repeats already, solved again.
std::optional<std::pair<SegmentShooting, Polished<Equations>>> shorter(
    const System& system, const SegmentShooting& shooting, const Vector& u) {
  const SegmentLayout& whole = shooting.layout();
  for (int p = 1; p < whole.period; ++p) {
    if (whole.period % p != 0) continue;
    SegmentLayout less = whole;
    less.period = p;
    less.sections = std::max(1, whole.sections * p / whole.period);
    const SegmentShooting part = shooting.over(std::move(less));
    const Vector first = u.head(part.size());
    if (u.size() > part.size() &&
        (u.tail(u.size() - part.size()) - u.head(u.size() - part.size())).norm() >
            kShootingAccuracy * (1.0 + u.norm()))
      continue;
    const std::vector<MotionState<double>> starts =
        starts_of(part.timed(system, first), part, first);
    const std::vector<TrajectorySegment> segments = part.follow(system, first);
    if (starts.empty() || segments.empty() || closed_stops(segments.back().end) != whole.closed ||
        !(whole_residual(system, starts, segments) <= kShootingAccuracy))
      continue;
    if (auto solution = newton(system, part, first)) return std::pair(part, std::move(*solution));
  }
  return {};
}

// Why the equations cannot be evaluated there; empty where they can.
std::string why_not_followed(const System& system, const SegmentShooting& shooting,
                             const Vector& u) {
  std::string why;
  for (int i = 0; i < shooting.layout().sections && why.empty(); ++i)
    why = shooting.map().why_no_image(system, shooting.at_section(u, i), shooting.theta_of(u),
                                      shooting.periods_each());
  return why;
}

FollowedAnswer solve_from(const System& system, SegmentShooting shooting, const Vector& u) {
  auto solution = newton(system, shooting, u);
  // Without unknowns no motion has been followed yet.
  if (!solution || u.size() == 0) {
    std::string why = why_not_followed(system, shooting, u);
    if (!why.empty()) return {{}, std::move(why)};
  }
  if (!solution) return {{}, "Newton's method does not converge on the section"};
  if (auto part = shorter(system, shooting, solution->u)) {
    shooting = part->first;
    solution = std::move(part->second);
  }
  FollowedAnswer answer;
  answer.orbit = orbit_of(system, shooting, solution->u,
                          shooting.multipliers(system, solution->at.slopes, ErrorBounds::kGiven));
  if (answer.orbit && !(answer.orbit->residual <= kShootingTolerance)) answer.orbit.reset();
  if (!answer.orbit)
    answer.why_not = shooting.layout().closed.empty()
                         ? "the periodic motion meets no stop, never leaves one, or comes to rest "
                           "on one that is rigid"
                         : "the motion does not come back to its stuck phase";
  return answer;
}

// The middle of the longest stretch of a segment during which most stops are closed, s.
std::optional<double> stuck_instant(const System& system, const TrajectorySegment& segment) {
  const auto time = [&](const Instant<double>& at) { return seconds_between(system, {}, at); };
  std::vector<double> ends;
  for (const SegmentSticking& sticking : segment.sticking) {
    ends.push_back(time(sticking.from));
    ends.push_back(time(sticking.to));
  }
  std::sort(ends.begin(), ends.end());
  std::optional<double> middle;
  std::ptrdiff_t most = 0;
  double longest = 0.0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double from = ends[i - 1], to = ends[i], now = 0.5 * (from + to);
    const auto closed = std::count_if(segment.sticking.begin(), segment.sticking.end(),
                                      [&](const SegmentSticking& sticking) {
                                        return time(sticking.from) < now && now < time(sticking.to);
                                      });
    if (closed < most || closed == 0 || (closed == most && !(to - from > longest))) continue;
    middle = now;
    most = closed;
    longest = to - from;
  }
  return middle;
}

SegmentShooting stuck_at(const System& system, const MotionState<double>& at, int period,
                         const SegmentOptions& options) {
  const double theta = system.forcing()->phase + system.forcing()->frequency * at.instant.local;
  return {system, {period, 1, closed_stops(at), {}, theta}, options};
}

// The orbit from a motion whose first period was followed, and sticks.
FollowedAnswer stuck_orbit(const System& system, const MotionState<double>& start,
                           const TrajectorySegment& first, int period,
                           const SegmentOptions& options) {
  if (first.sticking.empty())
    return {{}, fmt::format("no stop is closed within {} forcing periods", period)};
  if (first.impacts.empty())
    return {{},
            fmt::format("stop {} holds the structure without any impact: no impacting orbit",
                        first.sticking.front().stop + 1)};
  const std::optional<double> instant = stuck_instant(system, first);
  if (!instant) return {{}, "no stop is closed for longer than an instant"};
  const double periods = std::floor(*instant / system.period());
  const TrajectorySegment to_section =
      pass(system, start,
           {static_cast<long long>(periods),
            std::clamp(*instant - periods * system.period(), 0.0, system.period())},
           options);
  if (!to_section.failure.empty()) return {{}, to_section.failure};
  const SegmentShooting shooting = stuck_at(system, to_section.end, period, options);
  return solve_from(system, shooting,
                    shooting.pack(system, {{to_section.end.q, to_section.end.qdot}}));
}

// The orbit of a solution at a release, by a section within the stuck phase before it.
std::optional<Orbit> orbit_at_release(const System& system, const SegmentShooting& shooting,
                                      const Vector& u) {
  const std::optional<ReleaseReturn> back = return_of(system, shooting, u);
  if (!back || !back->returns) return {};
  const SegmentLayout& layout = shooting.layout();
  // Half-way back to where the last of the stops closed.
  const Instant<double>& end = back->segment.end.instant;
  double held = layout.period * system.period();
  for (const SegmentSticking& sticking : back->segment.sticking) {
    if (sticking.from_start) continue;
    const bool lasts = sticking.to_end || sticking.stop == layout.released;
    if (lasts &&
        std::find(layout.closed.begin(), layout.closed.end(), sticking.stop) != layout.closed.end())
      held = std::min(held, seconds_between(system, sticking.from, end));
  }
  Instant<double> middle = end;
  middle.local -= 0.5 * held;
  while (middle.local < 0.0) {
    middle.local += system.period();
    --middle.period;
  }
  const auto start =
      shooting.map().start_of(system, shooting.at_section(u, 0), shooting.theta_of(u));
  const TrajectorySegment to_middle = pass(system, *start, middle, shooting.map().options());
  if (!to_middle.failure.empty()) return {};
  return orbit_through(system, to_middle.end, layout.period, shooting.map().options()).orbit;
}

}  // namespace

std::optional<Orbit> orbit_of(const System& given, const SegmentShooting& shooting, const Vector& u,
                              std::vector<Eigenvalue> multipliers,
                              const std::optional<GrazingContact>& grazing) {
  const System system = shooting.timed(given, u);
  if (shooting.layout().released) return orbit_at_release(system, shooting, u);
  const bool stuck = !shooting.layout().closed.empty();
  const std::vector<MotionState<double>> starts = starts_of(system, shooting, u);
  const std::vector<TrajectorySegment> segments = shooting.follow(system, u, true);
  if (starts.empty() || segments.empty()) return {};
  for (const TrajectorySegment& segment : segments) {
    // An orbit that also sticks has a map of lower rank and needs another section.
    if (!stuck && !segment.sticking.empty()) return {};
    if (closed_stops(segment.end) != shooting.layout().closed) return {};
  }
  Orbit orbit;
  orbit.period = shooting.layout().period;
  if (shooting.is_free()) orbit.lasts = orbit.period * system.period();
  orbit.residual = whole_residual(system, starts, segments);
  for (const TrajectorySegment& segment : segments) {
    const std::optional<double> clearance = segment.clearance();
    if (clearance && (!orbit.clearance || *clearance < *orbit.clearance))
      orbit.clearance = clearance;
  }
  OrbitSection& section = orbit.section.emplace();
  section.closure_speed = shooting.map().options().closure_speed;
  section.states = section_states(system, shooting, u, starts);
  if (section.states.empty()) return {};
  std::optional<MetGrazing> met;
  if (grazing) {
    const Vector x = shooting.at_section(u, static_cast<int>(grazing->turn));
    const auto at =
        shooting.map().within(system, x, shooting.theta_of(u), grazing->angle, false, {});
    if (!at) return {};
    met = MetGrazing{*grazing, at->at.instant, at->state};
  }
  add_events(system, segments, shooting.periods_each(), met, orbit);
  // What rubs has to slide: rests there are not isolated, and no cycle is one of belts.
  if (!system.frictions.empty() && orbit.impacts.empty() && orbit.rubbing.empty() &&
      (shooting.is_free() || !slides_on(starts.front())))
    return {};
  // Contacts at speeds within rounding belong to a structure at rest.
  const double still = still_speed(system);
  if (!stuck && !grazing && system.frictions.empty() &&
      std::none_of(orbit.impacts.begin(), orbit.impacts.end(),
                   [&](const OrbitImpact& impact) { return impact.speed > still; }))
    return {};
  orbit.admissible = true;
  orbit.multipliers = std::move(multipliers);
  orbit.stable = stability(orbit.multipliers);
  return orbit;
}

std::vector<State> turns_of(const Orbit& orbit) {
  std::vector<State> turns;
  for (const MotionState<double>& turn : orbit.section->states)
    turns.push_back({turn.q, turn.qdot});
  return turns;
}

FollowedAnswer followed_orbit(const System& system, const std::vector<State>& turns,
                              const SegmentOptions& options) {
  const SegmentShooting shooting(system, SegmentLayout::fixed_phase(static_cast<int>(turns.size())),
                                 options);
  return solve_from(system, shooting, shooting.pack(system, turns));
}

FollowedAnswer followed_orbit(const System& system, const State& at_period_start, int period,
                              const SegmentOptions& options) {
  const MotionState<double> start =
      Motion<double>(system, {}, at_period_start.q, at_period_start.qdot).state();
  if (system.has_rigid_stop()) {
    const TrajectorySegment first = pass(system, start, {period, 0.0}, options);
    if (!first.failure.empty()) return {{}, first.failure};
    const bool meets_some =
        !first.impacts.empty() || system.has_compliant_stop() || !system.frictions.empty();
    if (!first.sticking.empty() || !meets_some)
      return stuck_orbit(system, start, first, period, options);
  }
  const SegmentShooting shooting(system, SegmentLayout::fixed_phase(period), options);
  const double local = wrapped(-system.forcing()->phase) / system.forcing()->frequency;
  const Instant<double> section{0, local < system.period() ? local : 0.0};
  const TrajectorySegment to_section = pass(system, start, section, options);
  if (!to_section.failure.empty()) return {{}, to_section.failure};
  std::vector<State> turns{{to_section.end.q, to_section.end.qdot}};
  while (static_cast<int>(turns.size()) < period) {
    const auto turn =
        shooting.map().follow(system, shooting.map().pack(system, turns.back()), 0.0, 1);
    if (!turn) return {{}, "the motion cannot be followed"};
    turns.push_back({turn->end.q, turn->end.qdot});
  }
  return solve_from(system, shooting, shooting.pack(system, turns));
}

FollowedAnswer orbit_through(const System& system, const MotionState<double>& at_section,
                             int period, const SegmentOptions& options) {
  if (closed_stops(at_section).empty())
    return {{}, "no stop is closed where the orbit is said to stick"};
  const SegmentShooting shooting = stuck_at(system, at_section, period, options);
  const Vector u = shooting.pack(system, {{at_section.q, at_section.qdot}});
  std::optional<Orbit> orbit =
      orbit_of(system, shooting, u, shooting.multipliers(system, u, ErrorBounds::kGiven));
  if (!orbit) return {{}, "the motion does not come back to its stuck phase"};
  return {std::move(orbit), ""};
}

}  // namespace graze
