// The same run twice, bit for bit: cut into pieces and resumed, and with its stops listed in
// another order.
#include <cstring>
#include <numeric>

#include "graze/motion/simulation.hpp"
#include "property/scene_property.hpp"

namespace graze {
namespace {

using property::Prepared;
using property::Summary;

struct Record {
  Simulation result;
  std::vector<Event> events;
  std::vector<Sample> samples;
};

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool same(const Vector& a, const Vector& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return same(x, y); });
}
bool same(const Work& a, const Work& b) {
  return same(a.forcing, b.forcing) && same(a.load, b.load) && same(a.constraint, b.constraint) &&
         same(a.dissipation, b.dissipation);
}
bool same(const EnergyBalance& a, const EnergyBalance& b) {
  return same(a.start, b.start) && same(a.now, b.now) && same(a.work, b.work) &&
         same(a.impacts, b.impacts);
}
bool same(const Event& a, const Event& b) {
  return a.kind == b.kind && same(a.time, b.time) && a.period_index == b.period_index &&
         a.stop == b.stop && same(a.speed, b.speed) && a.phase.has_value() == b.phase.has_value() &&
         (!a.phase || same(*a.phase, *b.phase)) && same(a.energy_change, b.energy_change) &&
         a.impacts == b.impacts && same(a.closure_speed, b.closure_speed) && same(a.force, b.force);
}
bool same(const Sample& a, const Sample& b) {
  return same(a.time, b.time) && same(a.state.q, b.state.q) && same(a.state.qdot, b.state.qdot) &&
         a.forces == b.forces && a.energy.has_value() == b.energy.has_value() &&
         (!a.energy || same(*a.energy, *b.energy));
}

std::string told(const Event& event) {
  constexpr const char* kKinds[] = {"impact", "chatter", "stick", "release"};
  return fmt::format("{} on stop {} at {:.17g} s, speed {:.17g}, impacts {}, force {:.17g}",
                     kKinds[static_cast<int>(event.kind)], event.stop + 1, event.time, event.speed,
                     event.impacts, event.force);
}

void require_same(const std::vector<Event>& a, const std::vector<Event>& b) {
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
    if (i >= a.size() || i >= b.size() || !same(a[i], b[i]))
      RC_FAIL(fmt::format("event {} of {} and {}: {} | {}", i + 1, a.size(), b.size(),
                          i < a.size() ? told(a[i]) : "none", i < b.size() ? told(b[i]) : "none"));
}

void require_same(const RunTotals& a, const RunTotals& b) {
  RC_ASSERT(a.impacts == b.impacts);
  RC_ASSERT(a.chatters == b.chatters);
  RC_ASSERT(a.clamped_restitutions == b.clamped_restitutions);
  RC_ASSERT(a.undecided_touches == b.undecided_touches);
  RC_ASSERT(same(a.stuck_time, b.stuck_time));
  RC_ASSERT(same(a.energy_added, b.energy_added));
  RC_ASSERT(same(a.energy_lost, b.energy_lost));
  RC_ASSERT(a.smallest_gap.value_or(1.0) == b.smallest_gap.value_or(1.0));
}

bool is_undecided(const Simulation& run) {
  return run.outcome == RunOutcome::kEventBudget && run.totals.impacts < property::kMostImpacts;
}

SimulationOptions options_of(const Prepared& prepared) {
  SimulationOptions options;
  options.duration = property::kPeriods * support::time_unit(prepared);
  options.max_impacts = property::kMostImpacts;
  options.energy = true;
  return options;
}

RunListeners listening(Record& record, double sample_rate) {
  RunListeners listeners;
  listeners.event = [&record](const Event& event) { record.events.push_back(event); };
  if (sample_rate > 0.0)
    listeners.sample = [&record](const Sample& sample) { record.samples.push_back(sample); };
  listeners.sample_rate = sample_rate;
  return listeners;
}

// Where to cut: after a part of the duration, or after a number of impacts.
struct Cut {
  double duration = 0.0;
  long long impacts = 0;
};

std::vector<Cut> random_cuts(const Prepared& prepared) {
  const SimulationOptions whole = options_of(prepared);
  constexpr int kParts = 1 << 20;
  std::vector<double> parts;
  const int count = *rc::gen::inRange(1, 4);
  for (int i = 0; i < count; ++i)
    parts.push_back(static_cast<double>(*rc::gen::inRange(0, kParts)) / kParts);
  std::sort(parts.begin(), parts.end());
  std::vector<Cut> cuts;
  for (const double part : parts) cuts.push_back({part * *whole.duration, whole.max_impacts});
  const Cut by_impacts{*whole.duration, *rc::gen::inRange(0, 40)};
  if (*rc::gen::inRange(0, 2) == 0) cuts = {by_impacts};
  return cuts;
}

TEST(RandomScene, CutAndResumedIsTheSameRun) {
  property::for_random_scenes([](const Prepared& prepared, Summary& summary) {
    SimulationOptions options = options_of(prepared);
    // With samples or with the balance: the work up to each sample costs as much as that of a whole
    // arc.
    options.energy = *rc::gen::inRange(0, 2) == 0;
    const double rate = options.energy ? 0.0 : 20.0 / support::time_unit(prepared);
    Record whole, pieces;
    whole.result = simulate(prepared.system, prepared.start, options, listening(whole, rate));
    std::optional<RunState> state;
    std::vector<Cut> cuts = random_cuts(prepared);
    cuts.push_back({*options.duration, options.max_impacts});
    for (const Cut& cut : cuts) {
      SimulationOptions piece = options;
      piece.duration = cut.duration;
      piece.max_impacts = cut.impacts;
      const RunListeners listeners = listening(pieces, rate);
      pieces.result = state ? resume(prepared.system, *state, piece, listeners)
                            : simulate(prepared.system, prepared.start, piece, listeners);
      state = pieces.result.state;
    }
    summary.count("scenes");
    summary.count("events", static_cast<long long>(whole.events.size()));
    if (is_undecided(whole.result)) {
      // Where the search gives up, a run that is resumed tries again and may get further.
      summary.count("undecided");
      pieces.events.resize(std::min(pieces.events.size(), whole.events.size()));
      require_same(whole.events, pieces.events);
      return;
    }
    require_same(whole.events, pieces.events);
    RC_ASSERT(whole.samples.size() == pieces.samples.size());
    for (std::size_t i = 0; i < whole.samples.size(); ++i)
      if (!same(whole.samples[i], pieces.samples[i]))
        RC_FAIL(fmt::format("sample {} at {:.17g} s", i, whole.samples[i].time));
    const Simulation &a = whole.result, &b = pieces.result;
    RC_ASSERT(a.outcome == b.outcome);
    RC_ASSERT(a.message == b.message);
    RC_ASSERT(same(a.end_time, b.end_time));
    RC_ASSERT(same(a.final.q, b.final.q) && same(a.final.qdot, b.final.qdot));
    RC_ASSERT(a.stuck == b.stuck);
    RC_ASSERT(a.forces == b.forces);
    require_same(a.totals, b.totals);
    if (options.energy) RC_ASSERT(same(*a.energy, *b.energy));
    summary.count("pieces", static_cast<long long>(cuts.size()));
  });
}

// Stops that do not differ are one: which of them is named is all the same.
int first_alike(const System& system, std::size_t i) {
  const auto alike = [&](const Stop& a, const Stop& b) {
    return same(a.row, b.row) && same(a.direction(), b.direction()) && same(a.gap, b.gap) &&
           a.restitution().coefficients() == b.restitution().coefficients();
  };
  for (std::size_t j = 0; j < i; ++j)
    if (alike(system.stops[j], system.stops[i])) return static_cast<int>(j);
  return static_cast<int>(i);
}

// Events of one instant come in the order of their stops.
void sort_instants(std::vector<Event>& events) {
  std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) {
    return a.time != b.time ? a.time < b.time : a.stop < b.stop;
  });
}

TEST(RandomScene, OrderOfTheStopsDoesNotMatter) {
  property::for_random_scenes([](const Prepared& prepared, Summary& summary) {
    const std::size_t stops = prepared.system.stops.size();
    if (stops < 2) return;
    std::vector<std::size_t> order(stops);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const int shuffles = *rc::gen::inRange(1, stops == 2 ? 2 : 6);
    for (int i = 0; i < shuffles; ++i) std::next_permutation(order.begin(), order.end());
    System listed = prepared.system;
    for (std::size_t i = 0; i < stops; ++i) listed.stops[i] = prepared.system.stops[order[i]];
    SimulationOptions options = options_of(prepared);
    options.energy = false;
    Record first, second;
    first.result = simulate(prepared.system, prepared.start, options, listening(first, 0.0));
    second.result = simulate(listed, prepared.start, options, listening(second, 0.0));
    for (Event& event : first.events)
      event.stop = first_alike(prepared.system, static_cast<std::size_t>(event.stop));
    for (Event& event : second.events)
      event.stop = first_alike(prepared.system, order[static_cast<std::size_t>(event.stop)]);
    sort_instants(first.events);
    sort_instants(second.events);
    require_same(first.events, second.events);
    const Simulation &a = first.result, &b = second.result;
    RC_ASSERT(a.outcome == b.outcome);
    RC_ASSERT(same(a.final.q, b.final.q) && same(a.final.qdot, b.final.qdot));
    std::vector<double> forces(stops), relisted(stops);
    for (std::size_t i = 0; i < stops; ++i) {
      forces[static_cast<std::size_t>(first_alike(prepared.system, i))] += a.forces[i];
      relisted[static_cast<std::size_t>(first_alike(prepared.system, order[i]))] += b.forces[i];
    }
    RC_ASSERT(forces == relisted);
    RC_ASSERT(a.totals.smallest_gap.value_or(1.0) == b.totals.smallest_gap.value_or(1.0));
    summary.count("scenes");
    summary.count("impacts", a.totals.impacts);
  });
}

}  // namespace
}  // namespace graze
