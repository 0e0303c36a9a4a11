#include "graze/orbit/problem/detail/itinerary.hpp"

#include <algorithm>
#include <limits>

namespace graze {
namespace {

bool before(const Instant<double>& a, const Instant<double>& b) { return !not_before(a, b); }

// Which impacts are no events: those of the chatters that lead to the stuck phases, and those that
// are rounding.
std::vector<bool> no_events(const std::vector<PassedImpact>& impacts,
                            const std::vector<const PassedHold*>& holds, double still) {
  std::vector<bool> none;
  for (const PassedImpact& impact : impacts) none.push_back(impact.speed <= still);
  for (const PassedHold* hold : holds) {
    double faster = 0.0;
    for (std::size_t i = impacts.size(); i-- > 0;) {
      const PassedImpact& impact = impacts[i];
      if (impact.stop != hold->stop || before(hold->from, impact.at)) continue;
      if (!(impact.speed > faster)) break;
      faster = impact.speed;
      none[i] = true;
    }
  }
  return none;
}

// An impact, or a contact with a compliant stop that begins.
struct Met {
  int stop = 0;
  Instant<double> at;
  double speed = 0.0;  // m/s
};

}  // namespace

std::vector<const PassedHold*> holds_begun(const Passage& passage) {
  std::vector<const PassedHold*> begun;
  for (const PassedHold& hold : passage.holds)
    if (!hold.from_start) begun.push_back(&hold);
  std::sort(begun.begin(), begun.end(),
            [](const PassedHold* a, const PassedHold* b) { return before(a->from, b->from); });
  return begun;
}

Itinerary itinerary_of(const Passage& passage, double still) {
  const std::vector<const PassedHold*> holds = holds_begun(passage);
  const std::vector<bool> none = no_events(passage.impacts, holds, still);
  std::vector<Met> met;
  for (std::size_t i = 0; i < passage.impacts.size(); ++i) {
    const PassedImpact& impact = passage.impacts[i];
    if (!none[i]) met.push_back({impact.stop, impact.at, impact.speed});
  }
  for (const PassedContact& contact : passage.contacts)
    if (!contact.from_start && contact.speed > still)
      met.push_back({contact.stop, contact.from, contact.speed});
  std::stable_sort(met.begin(), met.end(),
                   [](const Met& one, const Met& other) { return before(one.at, other.at); });
  Itinerary result;
  result.slowest = std::numeric_limits<double>::infinity();
  auto hold = holds.begin();
  for (const Met& one : met) {
    for (; hold != holds.end() && before((*hold)->from, one.at); ++hold)
      result.events.push_back(-1 - (*hold)->stop);
    result.events.push_back(one.stop);
    if (!(one.speed < result.slowest)) continue;
    result.slowest = one.speed;
    result.slowest_stop = one.stop;
    result.slowest_at = one.at;
  }
  for (; hold != holds.end(); ++hold) result.events.push_back(-1 - (*hold)->stop);
  return result;
}

std::vector<PassageMargin> margins_of(const Passage& passage, double still) {
  const std::vector<PassedImpact>& impacts = passage.impacts;
  const std::vector<bool> none = no_events(impacts, holds_begun(passage), still);
  const auto is_none_on = [&](std::size_t i, int stop) {
    return i < impacts.size() && none[i] && impacts[i].stop == stop;
  };
  std::vector<PassageMargin> margins;
  std::size_t place = 0;
  auto approach = passage.approaches.begin();
  for (std::size_t i = 0; i <= impacts.size(); ++i) {
    for (; approach != passage.approaches.end() && approach->impacts == i; ++approach)
      if (i == 0 || !is_none_on(i - 1, approach->stop) || !is_none_on(i, approach->stop))
        margins.push_back(
            {false, place, approach->stop, approach->after, approach->gap, approach->rate});
    if (i == impacts.size() || none[i]) continue;
    margins.push_back({true, place++, impacts[i].stop, 0.0, impacts[i].speed, impacts[i].rate});
  }
  return margins;
}

}  // namespace graze
