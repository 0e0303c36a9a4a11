#include "graze/report/chart/detail/motion_seen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>

#include "graze/report/appearance/looks.hpp"

namespace graze {
namespace {

using SamplesSeen = std::vector<const Sample*>;

double force_at(const Sample& sample, int stop) {
  const auto i = static_cast<std::size_t>(stop);
  return i < sample.forces.size() ? sample.forces[i] : 0.0;
}

// Samples may end up to one spacing before the end of the run, and the last events may lie between.
// A single sample has no known spacing.
bool window_reaches_end(const SimulationRecord& record) {
  const std::vector<Sample>& samples = record.samples;
  if (samples.size() < 2) return true;
  const double spacing =
      (samples.back().time - samples.front().time) / static_cast<double>(samples.size() - 1);
  return record.run.end_time - samples.back().time <= 1.5 * spacing;
}

TimeSpan window_of(const SimulationRecord& record) {
  if (record.samples.empty()) return {0.0, record.run.end_time};
  const double last = record.samples.back().time;
  return {record.samples.front().time,
          window_reaches_end(record) ? std::max(last, record.run.end_time) : last};
}

// The end of the run, if the samples end just before it.
std::optional<Sample> end_sample(const SimulationRecord& record) {
  const std::vector<Sample>& samples = record.samples;
  const Simulation& run = record.run;
  if (samples.empty() || !window_reaches_end(record) || run.end_time <= samples.back().time ||
      run.final.q.size() != samples.back().state.q.size())
    return {};
  Sample last{run.end_time, run.final, run.phase, run.forces, run.energy};
  for (const AtFriction& one : run.frictions) last.frictions.push_back(one.force);
  return last;
}

void gather_impacts(const SimulationRecord& record, const TimeSpan& window, SeenPlace& place) {
  for (const Event& event : record.events) {
    if (event.kind != EventKind::kImpact || event.time < window.start || event.time > window.end)
      continue;
    for (const SeenStop& stop : place.stops) {
      if (stop.index != event.stop) continue;
      const double restitution =
          record.system.stops[static_cast<std::size_t>(event.stop)].restitution().at(event.speed);
      const double before = stop.sense * event.speed;
      place.impacts.push_back({event.time, stop.place, before, -restitution * before});
    }
  }
}

void gather_motion(const SamplesSeen& samples, const TimeSpan& window, SeenPlace& place) {
  auto next = place.impacts.begin();
  const auto add_impacts_until = [&](double time) {
    for (; next != place.impacts.end() && next->time <= time; ++next)
      for (const double velocity : {next->before, std::nan(""), next->after})
        place.motion.push_back({next->time, next->place, velocity});
  };
  for (const Sample* sample : samples) {
    add_impacts_until(sample->time);
    // A sample at the very time of an impact may be before or after the jump.
    if (next != place.impacts.begin() && std::prev(next)->time == sample->time) continue;
    place.motion.push_back(
        {sample->time, place.row.dot(sample->state.q), place.row.dot(sample->state.qdot)});
  }
  add_impacts_until(window.end);
}

// Whether it is closed when the window begins: by its force, or, without samples, when it is closed
// at the end and no event of it came before.
bool begins_stuck(const SimulationRecord& record, int stop) {
  if (!record.samples.empty()) return force_at(record.samples.front(), stop) > 0.0;
  const std::vector<int>& stuck = record.run.stuck;
  return std::find(stuck.begin(), stuck.end(), stop) != stuck.end() &&
         std::none_of(record.events.begin(), record.events.end(),
                      [&](const Event& event) { return event.stop == stop; });
}

// The end of a contact has its largest force, which samples may miss, or the whole contact: it is
// drawn at their largest value, or, without samples, half way.
void add_largest_force(const Event& end, DrawnCurve& curve) {
  const double begin = end.time - end.duration;
  auto largest = curve.end();
  for (auto point = curve.end(); point != curve.begin() && std::prev(point)->time >= begin;) {
    --point;
    if (std::isfinite(point->value) && (largest == curve.end() || point->value > largest->value))
      largest = point;
  }
  if (largest != curve.end()) {
    largest->value = std::max(largest->value, end.peak_force);
    return;
  }
  curve.push_back({begin, 0.0});
  curve.push_back({0.5 * (begin + end.time), end.peak_force});
}

DrawnCurve force_curve(const SamplesSeen& samples, const SimulationRecord& record, int stop,
                       const TimeSpan& window) {
  DrawnCurve curve;
  const auto end_phase = [&](double time) {
    if (!curve.empty() && !std::isnan(curve.back().value)) curve.push_back({time, std::nan("")});
  };
  auto event = record.events.begin();
  const auto add_events_until = [&](double time) {
    for (; event != record.events.end() && event->time <= time; ++event) {
      if (event->stop != stop || event->time < window.start) continue;
      if (event->kind == EventKind::kStick) curve.push_back({event->time, event->force});
      if (event->kind == EventKind::kContact) {
        const ContactForce& law = record.system.stops[static_cast<std::size_t>(stop)].force();
        curve.push_back({event->time, 0.0});
        curve.push_back({event->time, law.at(0.0, event->speed)});
      }
      if (event->kind == EventKind::kSeparation) add_largest_force(*event, curve);
      if (event->kind == EventKind::kRelease || event->kind == EventKind::kSeparation) {
        curve.push_back({event->time, 0.0});
        end_phase(event->time);
      }
    }
  };
  for (const Sample* sample : samples) {
    add_events_until(sample->time);
    if (force_at(*sample, stop) > 0.0)
      curve.push_back({sample->time, force_at(*sample, stop)});
    else
      end_phase(sample->time);
  }
  add_events_until(window.end);
  return curve;
}

// When it stuck, within the window.
std::vector<TimeSpan> rests_of(const SimulationRecord& record, int friction,
                               const TimeSpan& window) {
  const auto is_own = [&](const Event& event) { return event.friction == friction; };
  const auto first = std::find_if(record.events.begin(), record.events.end(), is_own);
  const auto place = static_cast<std::size_t>(friction);
  const std::vector<AtFriction>& at_end = record.run.frictions;
  bool sticks = first != record.events.end() ? first->kind == EventKind::kSlip
                                             : place < at_end.size() && at_end[place].sticks;
  std::vector<TimeSpan> rests;
  double since = window.start;
  const auto end_at = [&](double time) {
    if (sticks && time > window.start) rests.push_back({std::max(since, window.start), time});
  };
  for (auto event = first; event != record.events.end() && event->time <= window.end; ++event) {
    if (!is_own(*event)) continue;
    end_at(event->time);
    sticks = event->kind == EventKind::kFrictionStick;
    since = event->time;
  }
  end_at(window.end);
  return rests;
}

std::vector<EnergyTerm> energy_terms(const SamplesSeen& samples, const System& system) {
  if (samples.empty() || !samples.front()->energy) return {};
  struct Entry {
    const char* name;
    const char* colour;
    bool present;
    std::function<double(const EnergyBalance&)> value;
  };
  const EnergyEntries has = energy_entries(system, EnergyBalance{});
  const bool turns = system.turns();
  // Signed, so that the energy rises by their sum.
  const Entry entries[] = {{turns ? "torque" : "forcing", kBlue, has.forcing.has_value(),
                            [](const EnergyBalance& balance) { return balance.work.forcing; }},
                           {turns ? "weight" : "load", kPurple, has.load.has_value(),
                            [](const EnergyBalance& balance) { return balance.work.load; }},
                           {"constraint", kOrange, has.constraint.has_value(),
                            [](const EnergyBalance& balance) { return balance.work.constraint; }},
                           {"moving stops", kIndigo, has.stops.has_value(),
                            [](const EnergyBalance& balance) { return balance.work.stops; }},
                           {"dry friction", kGrey, has.friction.has_value(),
                            [](const EnergyBalance& balance) { return balance.work.friction; }},
                           {"damping", kGreen, has.dissipation.has_value(),
                            [](const EnergyBalance& balance) { return -balance.work.dissipation; }},
                           {"impacts", kVermillion, has.impacts.has_value(),
                            [](const EnergyBalance& balance) { return balance.impacts; }},
                           {"contact", kSky, has.contact.has_value(),
                            [](const EnergyBalance& balance) { return balance.work.contact; }}};
  std::vector<EnergyTerm> terms{{"energy", kBlack, {}}};
  for (const Sample* sample : samples)
    if (sample->energy) terms[0].curve.push_back({sample->time, sample->energy->now});
  for (const Entry& entry : entries) {
    if (!entry.present) continue;
    EnergyTerm term{entry.name, entry.colour, {}};
    const double before = entry.value(*samples.front()->energy);
    for (const Sample* sample : samples)
      if (sample->energy)
        term.curve.push_back({sample->time, entry.value(*sample->energy) - before});
    const auto zero = [](const DrawnPoint& point) { return point.value == 0.0; };
    if (!std::all_of(term.curve.begin(), term.curve.end(), zero)) terms.push_back(term);
  }
  return terms;
}

std::vector<SeenProbe> probes_seen(const SamplesSeen& samples, const System& system,
                                   const std::vector<ProbeRow>& probes) {
  if (samples.empty()) return {};
  std::vector<SeenProbe> seen;
  for (const ProbeRow& probe : probes) {
    SeenProbe curve{static_cast<int>(seen.size()) + 1, probe.quantity, {}};
    for (const Sample* sample : samples)
      curve.curve.push_back({sample->time, probe.value(structure_state(system, sample->state, sample->phase))});
    seen.push_back(std::move(curve));
  }
  return seen;
}

}  // namespace

ChartFill behind(const SeenStop& stop, bool is_upright) {
  constexpr double kEnd = std::numeric_limits<double>::infinity();
  return {is_upright, stop.sense > 0.0 ? stop.place : -kEnd, stop.sense > 0.0 ? kEnd : stop.place,
          "behind the stop", kStopShade};
}

bool is_near(const SeenStop& stop, const AxisRange& motion) {
  if (motion.empty()) return true;
  const double reach = 4.0 * std::max(motion.span(), 0.25 * largest(motion));
  return stop.place >= motion.low - reach && stop.place <= motion.high + reach;
}

std::vector<TimeSpan> stuck_phases(const SimulationRecord& record, int stop,
                                   const TimeSpan& window) {
  std::vector<TimeSpan> phases;
  // A structure does not stick to a spring.
  if (record.system.stops[static_cast<std::size_t>(stop)].is_compliant()) return phases;
  bool closed = begins_stuck(record, stop);
  // While open, the time of the stop's last event: a release without a stick before it, as where it
  // cuts the tail of a chatter short, ends a phase that began there.
  double since = window.start;
  for (const Event& event : record.events) {
    if (event.stop != stop || event.time < window.start || event.time > window.end) continue;
    if (event.kind == EventKind::kRelease) phases.push_back({since, event.time});
    if (closed && event.kind != EventKind::kRelease) continue;
    closed = event.kind == EventKind::kStick;
    since = event.time;
  }
  if (closed) phases.push_back({since, window.end});
  return phases;
}

std::vector<SeenPlace> places_of(const System& system) {
  std::vector<SeenPlace> places;
  const auto place_of = [&](const Vector& row) -> std::pair<SeenPlace&, double> {
    for (SeenPlace& known : places)
      for (const double sense : {1.0, -1.0})
        if ((row - sense * known.row).norm() <= 1e-9 * row.norm()) return {known, sense};
    return {places.emplace_back(SeenPlace{row, {}, {}, {}, {}, {}}), 1.0};
  };
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    const auto [place, sense] = place_of(system.stops[i].row);
    place.stops.push_back({static_cast<int>(i), sense, sense * system.stops[i].gap});
  }
  for (std::size_t k = 0; k < system.frictions.size(); ++k)
    place_of(system.frictions[k].row).first.frictions.push_back(static_cast<int>(k));
  if (places.empty()) place_of(Vector::Unit(system.modes(), 0));
  return places;
}

std::string SeenPlace::name(const System& system) const {
  if (is_modal()) return "q_1";
  const auto numbered = [](const char* what, std::size_t count, int index) {
    return count > 1 ? fmt::format("{} {}", what, index + 1) : std::string(what);
  };
  return stops.empty() ? numbered("friction", system.frictions.size(), frictions.front())
                       : numbered("stop", system.stops.size(), stops.front().index);
}

std::string SeenPlace::towards(const System& system) const {
  return (stops.empty() ? is_modal() ? "" : "at " : "→ ") + name(system);
}

MotionSeen motion_seen(const SimulationRecord& record) {
  MotionSeen seen;
  seen.window = window_of(record);
  seen.places = places_of(record.system);
  SamplesSeen samples;
  for (const Sample& sample : record.samples) samples.push_back(&sample);
  const std::optional<Sample> end = end_sample(record);
  if (end) samples.push_back(&*end);
  for (SeenPlace& place : seen.places) {
    gather_impacts(record, seen.window, place);
    gather_motion(samples, seen.window, place);
    for (const SeenStop& stop : place.stops)
      for (const TimeSpan& phase : stuck_phases(record, stop.index, seen.window))
        place.stuck.push_back({phase, stop.place});
    for (const int friction : place.frictions)
      for (const TimeSpan& rest : rests_of(record, friction, seen.window))
        place.stuck.push_back({rest, std::nan("")});
  }
  for (std::size_t k = 0; k < record.system.frictions.size(); ++k) {
    DrawnCurve& force = seen.rubbing.emplace_back();
    for (const Sample* sample : samples)
      if (k < sample->frictions.size()) force.push_back({sample->time, sample->frictions[k]});
  }
  for (int i = 0; i < static_cast<int>(record.system.stops.size()); ++i) {
    DrawnCurve force = force_curve(samples, record, i, seen.window);
    if (!force.empty()) seen.forces.push_back({i, std::move(force)});
  }
  seen.energy = energy_terms(samples, record.system);
  seen.probes = probes_seen(samples, record.system, record.probes);
  return seen;
}

}  // namespace graze
