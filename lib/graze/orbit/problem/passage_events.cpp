#include "graze/orbit/problem/detail/passage_events.hpp"

#include <algorithm>

#include "graze/orbit/problem/detail/orbit_clock.hpp"

namespace graze {
namespace {

double seconds(const System& system, const PassedContact& contact) {
  return seconds_between(system, contact.from, contact.to);
}

// The parts of what lasts over the end of the passage `index`, in those that follow; `of` tells the
// contacts or the stuck phases of one.
template <class Part, class Of, class Add>
void go_on(const std::vector<Passage>& passages, std::size_t index, const Part& first, const Of& of,
           const Add& add) {
  const Part* part = &first;
  for (std::size_t i = 1; part->to_end && i <= passages.size(); ++i) {
    const std::vector<Part>& next = of(passages[(index + i) % passages.size()]);
    const auto rest = std::find_if(next.begin(), next.end(), [&](const Part& one) {
      return one.from_start && one.stop == first.stop;
    });
    if (rest == next.end()) return;
    part = &*rest;
    add(*part, (index + i) % passages.size());
  }
}

OrbitContact whole_contact(const System& system, const std::vector<Passage>& passages,
                           std::size_t index, const PassedContact& first) {
  OrbitContact whole{seconds(system, first), first.speed_after, first.peak_force, first.taken};
  go_on(
      passages, index, first, [](const Passage& passage) -> auto& { return passage.contacts; },
      [&](const PassedContact& part, std::size_t) {
        whole.duration += seconds(system, part);
        whole.speed_after = part.speed_after;
        whole.peak_force = std::max(whole.peak_force, part.peak_force);
        whole.taken += part.taken;
      });
  return whole;
}

// One as long before or after the touch as it lasts at the most: the instant is known less well
// than the depth.
bool is_touch(const System& system, const MetTouch& met, std::size_t turn,
              const PassedContact& contact) {
  if (turn != met.touch.turn || contact.stop != met.touch.stop || contact.speed > met.touch.slowest)
    return false;
  const double lasts = seconds(system, contact);
  const double since = seconds_between(system, contact.from, met.at);
  return since >= -lasts && since <= 2.0 * lasts;
}

class EventsOfOrbit {
 public:
  EventsOfOrbit(const System& system, const std::vector<Passage>& passages, int periods)
      : system_(system), passages_(passages), periods_(periods) {}

  void add(const std::optional<MetTouch>& touch, Orbit& orbit) const {
    std::vector<Instant<double>> instants;
    std::vector<OrbitImpact> met;
    for (std::size_t turn = 0; turn < passages_.size(); ++turn) {
      for (const PassedImpact& impact : passages_[turn].impacts) {
        instants.push_back(counted(impact.at, turn));
        met.push_back({impact.stop, 0, 0.0, impact.speed, impact.before});
      }
      for (const PassedContact& contact : passages_[turn].contacts) {
        if (contact.from_start || (touch && is_touch(system_, *touch, turn, contact))) continue;
        instants.push_back(counted(contact.from, turn));
        met.push_back({contact.stop, 0, 0.0, contact.speed, contact.before,
                       whole_contact(system_, passages_, turn, contact)});
      }
    }
    if (touch) {
      instants.push_back(counted(touch->at, touch->touch.turn));
      met.push_back({touch->touch.stop, 0, 0.0, 0.0, touch->state});
      if (system_.stops[static_cast<std::size_t>(touch->touch.stop)].is_compliant())
        met.back().contact = OrbitContact{};
    }
    const OrbitClock clock(system_, static_cast<int>(passages_.size()) * periods_, instants);
    for (std::size_t i = 0; i < met.size(); ++i) {
      const OrbitInstant at = clock(instants[i]);
      met[i].period_index = at.period_index;
      met[i].phase = at.phase;
    }
    std::stable_sort(met.begin(), met.end(), [](const OrbitImpact& a, const OrbitImpact& b) {
      return earlier({a.period_index, a.phase}, {b.period_index, b.phase});
    });
    orbit.impacts = std::move(met);
    orbit.holds = holds(clock);
    orbit.section->at = clock(orbit.section->states.front().instant);
  }

 private:
  // Instants are counted from the start of the orbit.
  Instant<double> counted(Instant<double> at, std::size_t turn) const {
    at.period += static_cast<long long>(turn) * periods_;
    return at;
  }

  std::vector<OrbitHold> holds(const OrbitClock& clock) const {
    std::vector<OrbitHold> list;
    for (std::size_t turn = 0; turn < passages_.size(); ++turn)
      for (const PassedHold& hold : passages_[turn].holds) {
        const bool all_through = hold.from_start && hold.to_end && turn == 0;
        if (hold.from_start && !all_through) continue;  // the end of another
        OrbitHold whole{hold.stop,
                        clock(counted(hold.from, turn)),
                        clock(counted(hold.to, turn)),
                        seconds_between(system_, hold.from, hold.to),
                        hold.force,
                        hold.smallest_force};
        if (all_through) {
          if (passages_.size() > 1) continue;
          list.push_back(whole);
          continue;
        }
        go_on(
            passages_, turn, hold, [](const Passage& passage) -> auto& { return passage.holds; },
            [&](const PassedHold& rest, std::size_t at) {
              whole.to = clock(counted(rest.to, at));
              whole.duration += seconds_between(system_, rest.from, rest.to);
              if (rest.smallest_force)
                whole.smallest_force = std::min(whole.smallest_force.value_or(*rest.smallest_force),
                                                *rest.smallest_force);
            });
        list.push_back(whole);
      }
    std::sort(list.begin(), list.end(), [](const OrbitHold& a, const OrbitHold& b) {
      return earlier(a.from, b.from) || (!earlier(b.from, a.from) && a.stop < b.stop);
    });
    return list;
  }

  const System& system_;
  const std::vector<Passage>& passages_;
  int periods_;
};

}  // namespace

void add_events(const System& system, const std::vector<Passage>& passages, int periods,
                const std::optional<MetTouch>& touch, Orbit& orbit) {
  EventsOfOrbit(system, passages, periods).add(touch, orbit);
}

}  // namespace graze
