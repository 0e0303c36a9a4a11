#include "graze/orbit/release.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/orbit/solve.hpp"
#include "graze/system/scale.hpp"

namespace graze {

std::optional<ReleaseReturn> return_of(const System& system, const PassageShooting& shooting,
                                       const Vector& u, bool minima) {
  std::vector<Passage> passages = shooting.follow(system, u, minima);
  if (passages.empty()) return {};
  const PassageLayout& layout = shooting.layout();
  ReleaseReturn result;
  result.passage = std::move(passages.front());
  const Instant<double>& end = result.passage.end.instant;
  const std::vector<const PassedHold*> begun = holds_begun(result.passage);
  const Itinerary itinerary = itinerary_of(result.passage, still_speed(system));
  result.itinerary = itinerary.events;
  result.slowest = itinerary.slowest;
  result.shortest_hold = std::numeric_limits<double>::infinity();
  // The release is where the force equation has it, to the accuracy of a solution.
  const double together = kShootingAccuracy * system.period();
  for (const PassedHold* hold : begun) {
    result.holds.push_back(hold->stop);
    double duration = seconds_between(system, hold->from, hold->to);
    const bool at_end = hold->to_end || seconds_between(system, hold->to, end) <= together;
    if (hold->stop == layout.released && at_end) result.returns = true;
    if (hold->to_end)
      for (const PassedHold& rest : result.passage.holds)
        if (rest.from_start && rest.stop == hold->stop)
          duration += seconds_between(system, rest.from, rest.to);
    result.shortest_hold = std::min(result.shortest_hold, duration);
  }
  for (const int i : layout.closed)
    if (i != layout.released &&
        result.passage.end.contacts[static_cast<std::size_t>(i)] != Contact::kClosed)
      result.returns = false;
  return result;
}

std::optional<Orbit> orbit_at_release(const System& system, const PassageShooting& shooting,
                                      const Vector& u) {
  const std::optional<ReleaseReturn> back = return_of(system, shooting, u);
  if (!back || !back->returns) return {};
  const PassageLayout& layout = shooting.layout();
  // Half-way back to where the last of the stops closed.
  const Instant<double>& end = back->passage.end.instant;
  double held = layout.period * system.period();
  for (const PassedHold& hold : back->passage.holds) {
    if (hold.from_start) continue;
    const bool lasts = hold.to_end || hold.stop == layout.released;
    if (lasts &&
        std::find(layout.closed.begin(), layout.closed.end(), hold.stop) != layout.closed.end())
      held = std::min(held, seconds_between(system, hold.from, end));
  }
  Instant<double> middle = end;
  middle.local -= 0.5 * held;
  while (middle.local < 0.0) {
    middle.local += system.period();
    --middle.period;
  }
  const auto start =
      shooting.map().start_of(system, shooting.at_section(u, 0), shooting.theta_of(u));
  const Passage to_middle = pass(system, *start, middle, shooting.map().options());
  if (!to_middle.failure.empty()) return {};
  return orbit_through(system, to_middle.end, layout.period, shooting.map().options()).orbit;
}

std::vector<OrbitRelease> releases_of(const System& system, const Orbit& orbit,
                                      const PassageOptions& options) {
  struct Found {
    OrbitRelease release;
    double held = 0.0;  // s
  };
  std::vector<Found> found;
  const MotionState<double>& start = orbit.section->states.front();
  const Passage round =
      pass(system, start, {start.instant.period + orbit.period, start.instant.local}, options);
  for (const PassedHold& hold : round.holds) {
    if (hold.to_end) continue;
    const Passage there = pass(system, start, hold.to, options);
    if (!there.failure.empty()) continue;
    Found one;
    PassageLayout& layout = one.release.layout;
    layout.period = orbit.period;
    layout.released = hold.stop;
    for (std::size_t i = 0; i < there.end.contacts.size(); ++i)
      if (static_cast<int>(i) == hold.stop || there.end.contacts[i] == Contact::kClosed)
        layout.closed.push_back(static_cast<int>(i));
    one.release.theta =
        wrapped(system.forcing()->frequency * hold.to.local + system.forcing()->phase);
    one.release.state = {there.end.q, there.end.qdot};
    one.held = seconds_between(system, hold.from, hold.to);
    for (const PassedHold& before : round.holds)
      if (hold.from_start && before.to_end && before.stop == hold.stop)
        one.held += seconds_between(system, before.from, before.to);
    found.push_back(std::move(one));
  }
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    const std::size_t at_a = a.release.layout.closed.size(), at_b = b.release.layout.closed.size();
    return at_a != at_b ? at_a > at_b : a.held > b.held;
  });
  std::vector<OrbitRelease> releases;
  for (Found& one : found) releases.push_back(std::move(one.release));
  return releases;
}

}  // namespace graze
