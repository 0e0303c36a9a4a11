#include "graze/orbit/problem/detail/release.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// A stuck phase that lasts less than this part of a forcing period has shrunk to nothing: what
// 1e-10 of the parameter leaves of it beside CH, (1e-10)^(3/5).
constexpr double kGone = 1e-6;

}  // namespace

std::optional<ReleaseReturn> return_of(const System& system, const PassageShooting& shooting,
                                       const Vector& u, bool minima) {
  std::vector<Passage> passages = shooting.follow(system, u, minima);
  if (passages.empty()) return {};
  const PassageLayout& layout = shooting.layout();
  ReleaseReturn result;
  result.passage = std::move(passages.front());
  const Instant<double>& end = result.passage.end.instant;
  const std::vector<const PassedHold*> begun = holds_begun(result.passage);
  result.itinerary = itinerary_of(result.passage, still_speed(system));
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

bool has_shrunk(const ReleaseReturn& back, double period) {
  return back.shortest_hold <= kGone * period;
}

}  // namespace graze
