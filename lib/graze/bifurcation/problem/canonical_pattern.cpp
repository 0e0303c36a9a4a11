#include "graze/bifurcation/problem/detail/canonical_pattern.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "graze/base/angle.hpp"

namespace graze {
namespace {

// The index of the impact with which the canonical order begins.
std::size_t canonical_start(const std::vector<int>& stops) {
  std::size_t best = 0;
  for (std::size_t turn = 1; turn < stops.size(); ++turn)
    for (std::size_t i = 0; i < stops.size(); ++i) {
      const int here = stops[(turn + i) % stops.size()], there = stops[(best + i) % stops.size()];
      if (here == there) continue;
      if (here < there) best = turn;
      break;
    }
  return best;
}

}  // namespace

ImpactPattern turned(ImpactPattern pattern, std::size_t turn) {
  std::rotate(pattern.stops.begin(), pattern.stops.begin() + static_cast<std::ptrdiff_t>(turn),
              pattern.stops.end());
  return pattern;
}

std::vector<ImpactPoint> turned(std::vector<ImpactPoint> impacts, std::size_t turn, int period) {
  for (std::size_t i = 0; i < turn; ++i) impacts[i].theta += kTurn * period;
  std::rotate(impacts.begin(), impacts.begin() + static_cast<std::ptrdiff_t>(turn), impacts.end());
  const double back = impacts.front().theta - wrapped(impacts.front().theta);
  for (ImpactPoint& impact : impacts) impact.theta -= back;
  return impacts;
}

ImpactPattern canonical(ImpactPattern pattern) {
  const std::size_t start = canonical_start(pattern.stops);
  return turned(std::move(pattern), start);
}

std::vector<ImpactPoint> in_canonical_order(const ImpactPattern& pattern,
                                            std::vector<ImpactPoint> impacts) {
  return turned(std::move(impacts), canonical_start(pattern.stops), pattern.period);
}

std::vector<std::vector<ImpactPoint>> rewritings(const ImpactPattern& pattern,
                                                 const std::vector<ImpactPoint>& impacts) {
  std::vector<std::vector<ImpactPoint>> list;
  for (std::size_t turn = 0; turn < impacts.size(); ++turn)
    if (turned(pattern, turn).stops == pattern.stops)
      list.push_back(turned(impacts, turn, pattern.period));
  return list;
}

}  // namespace graze
