#include "graze/orbit/problem/detail/itinerary.hpp"

#include <algorithm>
#include <limits>

namespace graze {
namespace {

bool before(const Instant<double>& a, const Instant<double>& b) { return !not_before(a, b); }

// Which impacts do not count as events: those of the chatters that lead to the stuck phases, and
// those that are rounding.
std::vector<bool> no_events(const std::vector<SegmentImpact>& impacts,
                            const std::vector<const SegmentSticking*>& sticking, double still) {
  std::vector<bool> none;
  for (const SegmentImpact& impact : impacts) none.push_back(impact.speed <= still);
  for (const SegmentSticking* phase : sticking) {
    double faster = 0.0;
    for (std::size_t i = impacts.size(); i-- > 0;) {
      const SegmentImpact& impact = impacts[i];
      if (impact.stop != phase->stop || before(phase->from, impact.at)) continue;
      if (!(impact.speed > faster)) break;
      faster = impact.speed;
      none[i] = true;
    }
  }
  return none;
}

// An impact, or the begin of a contact with a compliant stop.
struct Met {
  int stop = 0;
  Instant<double> at;
  double speed = 0.0;  // m/s
};

}  // namespace

std::vector<const SegmentSticking*> sticking_begun(const TrajectorySegment& segment) {
  std::vector<const SegmentSticking*> begun;
  for (const SegmentSticking& sticking : segment.sticking)
    if (!sticking.from_start) begun.push_back(&sticking);
  std::sort(begun.begin(), begun.end(), [](const SegmentSticking* a, const SegmentSticking* b) {
    return before(a->from, b->from);
  });
  return begun;
}

Itinerary itinerary_of(const TrajectorySegment& segment, double still) {
  const std::vector<const SegmentSticking*> sticking = sticking_begun(segment);
  const std::vector<bool> none = no_events(segment.impacts, sticking, still);
  std::vector<Met> met;
  for (std::size_t i = 0; i < segment.impacts.size(); ++i) {
    const SegmentImpact& impact = segment.impacts[i];
    if (!none[i]) met.push_back({impact.stop, impact.at, impact.speed});
  }
  for (const SegmentContact& contact : segment.contacts)
    if (!contact.from_start && contact.speed > still)
      met.push_back({contact.stop, contact.from, contact.speed});
  std::stable_sort(met.begin(), met.end(),
                   [](const Met& one, const Met& other) { return before(one.at, other.at); });
  Itinerary result;
  result.slowest = std::numeric_limits<double>::infinity();
  auto next = sticking.begin();
  for (const Met& one : met) {
    for (; next != sticking.end() && before((*next)->from, one.at); ++next)
      result.events.push_back(-1 - (*next)->stop);
    result.events.push_back(one.stop);
    if (!(one.speed < result.slowest)) continue;
    result.slowest = one.speed;
    result.slowest_stop = one.stop;
    result.slowest_at = one.at;
  }
  for (; next != sticking.end(); ++next) result.events.push_back(-1 - (*next)->stop);
  return result;
}

std::vector<SegmentMargin> margins_of(const TrajectorySegment& segment, double still) {
  const std::vector<SegmentImpact>& impacts = segment.impacts;
  const std::vector<bool> none = no_events(impacts, sticking_begun(segment), still);
  const auto is_none_on = [&](std::size_t i, int stop) {
    return i < impacts.size() && none[i] && impacts[i].stop == stop;
  };
  std::vector<SegmentMargin> margins;
  std::size_t place = 0;
  auto approach = segment.approaches.begin();
  for (std::size_t i = 0; i <= impacts.size(); ++i) {
    for (; approach != segment.approaches.end() && approach->impacts == i; ++approach)
      if (i == 0 || !is_none_on(i - 1, approach->stop) || !is_none_on(i, approach->stop))
        margins.push_back(
            {false, place, approach->stop, approach->after, approach->gap, approach->rate});
    if (i == impacts.size() || none[i]) continue;
    margins.push_back({true, place++, impacts[i].stop, 0.0, impacts[i].speed, impacts[i].rate});
  }
  return margins;
}

}  // namespace graze
