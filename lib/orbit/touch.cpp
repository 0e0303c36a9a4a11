#include "graze/orbit/touch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/base/angle.hpp"
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
      offered.push_back({depth, {stop, turn, std::clamp(frequency * seconds, 0.0, kTurn), 0.0}});
    };
    if (passage.lowest)
      offer(std::abs(passage.lowest->gap) / length, passage.lowest->stop, passage.lowest->at, 0.0);
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

std::optional<Touch> nearest_touch(const System& system, const PassageShooting& shooting,
                                   const Vector& u) {
  const std::vector<Touch> touches = touches_near(system, shooting, u);
  if (touches.empty() ||
      !system.stops[static_cast<std::size_t>(touches.front().stop)].is_compliant())
    return {};
  return touches.front();
}

}  // namespace graze
