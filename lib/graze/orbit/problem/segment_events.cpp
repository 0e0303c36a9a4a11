#include "graze/orbit/problem/detail/segment_events.hpp"

#include <algorithm>
#include <cmath>

#include "graze/base/angle.hpp"

namespace graze {
namespace {

double seconds(const System& system, const SegmentContact& contact) {
  return seconds_between(system, contact.from, contact.to);
}

// Adds the later parts of a contact or stuck phase that lasts over the end of the segment `index`;
// `of` returns the contacts or the stuck phases of a segment.
template <class Part, class Of, class Add>
void go_on(const std::vector<TrajectorySegment>& segments, std::size_t index, const Part& first,
           const Of& of, const Add& add) {
  const Part* part = &first;
  for (std::size_t i = 1; part->to_end && i <= segments.size(); ++i) {
    const std::vector<Part>& next = of(segments[(index + i) % segments.size()]);
    const auto rest = std::find_if(next.begin(), next.end(), [&](const Part& one) {
      return one.from_start && one.stop == first.stop;
    });
    if (rest == next.end()) return;
    part = &*rest;
    add(*part, (index + i) % segments.size());
  }
}

OrbitContact whole_contact(const System& system, const std::vector<TrajectorySegment>& segments,
                           std::size_t index, const SegmentContact& first) {
  OrbitContact whole{seconds(system, first), first.speed_after, first.peak_force, first.taken};
  go_on(
      segments, index, first,
      [](const TrajectorySegment& segment) -> auto& { return segment.contacts; },
      [&](const SegmentContact& part, std::size_t) {
        whole.duration += seconds(system, part);
        whole.speed_after = part.speed_after;
        whole.peak_force = std::max(whole.peak_force, part.peak_force);
        whole.taken += part.taken;
      });
  return whole;
}

// A contact is the grazing one if its distance in time is at most its longest duration: the instant
// is known less accurately than the depth.
bool is_grazing_contact(const System& system, const MetGrazing& met, std::size_t turn,
                        const SegmentContact& contact) {
  if (turn != met.grazing.turn || contact.stop != met.grazing.stop ||
      contact.speed > met.grazing.slowest)
    return false;
  const double lasts = seconds(system, contact);
  const double since = seconds_between(system, contact.from, met.at);
  return since >= -lasts && since <= 2.0 * lasts;
}

class EventsOfOrbit {
 public:
  EventsOfOrbit(const System& system, const std::vector<TrajectorySegment>& segments, int periods)
      : system_(system), segments_(segments), periods_(periods) {}

  void add(const std::optional<MetGrazing>& grazing, Orbit& orbit) const {
    std::vector<Instant<double>> instants;
    std::vector<OrbitImpact> met;
    for (std::size_t turn = 0; turn < segments_.size(); ++turn) {
      for (const SegmentImpact& impact : segments_[turn].impacts) {
        instants.push_back(counted(impact.at, turn));
        met.push_back({impact.stop, 0, 0.0, impact.speed, impact.before});
      }
      for (const SegmentContact& contact : segments_[turn].contacts) {
        if (contact.from_start || (grazing && is_grazing_contact(system_, *grazing, turn, contact)))
          continue;
        instants.push_back(counted(contact.from, turn));
        met.push_back({contact.stop, 0, 0.0, contact.speed, contact.before,
                       whole_contact(system_, segments_, turn, contact)});
      }
    }
    if (grazing) {
      instants.push_back(counted(grazing->at, grazing->grazing.turn));
      met.push_back({grazing->grazing.stop, 0, 0.0, 0.0, grazing->state});
      if (system_.stops[static_cast<std::size_t>(grazing->grazing.stop)].is_compliant())
        met.back().contact = OrbitContact{};
    }
    const OrbitClock clock(system_, static_cast<int>(segments_.size()) * periods_, instants);
    for (std::size_t i = 0; i < met.size(); ++i) {
      const OrbitInstant at = clock(instants[i]);
      met[i].period_index = at.period_index;
      met[i].phase = at.phase;
    }
    std::stable_sort(met.begin(), met.end(), [](const OrbitImpact& a, const OrbitImpact& b) {
      return earlier({a.period_index, a.phase}, {b.period_index, b.phase});
    });
    orbit.impacts = std::move(met);
    orbit.sticking = sticking(clock);
    for (std::size_t turn = 0; turn < segments_.size(); ++turn)
      for (const SegmentRubbing& one : segments_[turn].rubbing)
        orbit.rubbing.push_back({one.friction, clock(counted(one.at, turn)), one.what, one.fall});
    std::stable_sort(orbit.rubbing.begin(), orbit.rubbing.end(),
                     [](const auto& a, const auto& b) { return earlier(a.at, b.at); });
    orbit.section->at = clock(orbit.section->states.front().instant);
  }

 private:
  // Instants are counted from the start of the orbit.
  Instant<double> counted(Instant<double> at, std::size_t turn) const {
    at.period += static_cast<long long>(turn) * periods_;
    return at;
  }

  std::vector<StickingPhase> sticking(const OrbitClock& clock) const {
    std::vector<StickingPhase> list;
    for (std::size_t turn = 0; turn < segments_.size(); ++turn)
      for (const SegmentSticking& sticking : segments_[turn].sticking) {
        const bool all_through = sticking.from_start && sticking.to_end && turn == 0;
        if (sticking.from_start && !all_through) continue;  // the end of another
        StickingPhase whole{sticking.stop,
                            clock(counted(sticking.from, turn)),
                            clock(counted(sticking.to, turn)),
                            seconds_between(system_, sticking.from, sticking.to),
                            sticking.force,
                            sticking.smallest_force};
        if (all_through) {
          if (segments_.size() > 1) continue;
          list.push_back(whole);
          continue;
        }
        go_on(
            segments_, turn, sticking,
            [](const TrajectorySegment& segment) -> auto& { return segment.sticking; },
            [&](const SegmentSticking& rest, std::size_t at) {
              whole.to = clock(counted(rest.to, at));
              whole.duration += seconds_between(system_, rest.from, rest.to);
              if (rest.smallest_force)
                whole.smallest_force = std::min(whole.smallest_force.value_or(*rest.smallest_force),
                                                *rest.smallest_force);
            });
        list.push_back(whole);
      }
    std::sort(list.begin(), list.end(), [](const StickingPhase& a, const StickingPhase& b) {
      return earlier(a.from, b.from) || (!earlier(b.from, a.from) && a.stop < b.stop);
    });
    return list;
  }

  const System& system_;
  const std::vector<TrajectorySegment>& segments_;
  int periods_;
};

}  // namespace

void add_events(const System& system, const std::vector<TrajectorySegment>& segments, int periods,
                const std::optional<MetGrazing>& grazing, Orbit& orbit) {
  EventsOfOrbit(system, segments, periods).add(grazing, orbit);
}

OrbitClock::OrbitClock(const System& system, int period,
                       const std::vector<Instant<double>>& impacts)
    : forcing_(*system.forcing()), period_(period) {
  const Instant<double>* first = nullptr;
  double smallest = 0.0;
  for (const Instant<double>& at : impacts) {
    const double phase = wrapped(theta(at));
    if (first && !(phase < smallest)) continue;
    first = &at;
    smallest = phase;
  }
  if (first) origin_ = turns(*first);
}

OrbitInstant OrbitClock::operator()(const Instant<double>& at) const {
  const long long index = (turns(at) - origin_) % period_;
  return {static_cast<int>(index < 0 ? index + period_ : index), wrapped(theta(at))};
}

double OrbitClock::theta(const Instant<double>& at) const {
  return forcing_.frequency * at.local + forcing_.phase;
}

long long OrbitClock::turns(const Instant<double>& at) const {
  return at.period + std::llround((theta(at) - wrapped(theta(at))) / kTurn);
}

bool earlier(const OrbitInstant& a, const OrbitInstant& b) {
  return a.period_index != b.period_index ? a.period_index < b.period_index : a.phase < b.phase;
}

}  // namespace graze
