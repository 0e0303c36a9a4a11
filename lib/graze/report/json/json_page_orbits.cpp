#include "graze/report/json/detail/json_page_orbits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/detail/orbit_curve.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/record/names/motion_names.hpp"
#include "graze/report/chart/detail/motion_seen.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostOrbitPlaces = 3;
constexpr double kSamplesPerTurn = 24.0;  // of the fastest mode, which is seen in a phase portrait
constexpr int kFewest = 128, kLeastPerPeriod = 32;
constexpr long long kShownPeriods = 12;     // of a motion that does not repeat
constexpr long long kMostImpacts = 20'000;  // followed for a picture
constexpr std::size_t kListedImpacts = 400;
constexpr const char* kFromThere = "The command starts from the state of the sweep at this value.";

int samples_per_period(const PageSource& source, const System& system, long long periods) {
  return std::max(kLeastPerPeriod,
                  page_samples(system, periods, source.most_samples) / static_cast<int>(periods));
}

struct PlaceSeries {
  std::vector<float> t, x, v;  // forcing periods, m, m/s; NaN where it jumps

  void add(double time, double displacement, double velocity) {
    t.push_back(static_cast<float>(time));
    x.push_back(static_cast<float>(displacement));
    v.push_back(static_cast<float>(velocity));
  }
  void gap() {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    add(kNone, kNone, kNone);
  }
};

// The unit in which numbers of that size are shown, as on the axis of a picture.
template <class Numbers>
Json unit_json(Units units, const std::string& si_unit, const Numbers& numbers) {
  double largest = 0.0;
  for (const double number : numbers)
    if (std::isfinite(number)) largest = std::max(largest, std::abs(number));
  const AxisUnit unit = axis_unit(unit_in(units, si_unit), largest);
  return {{"factor", unit.factor}, {"unit", plain_text(unit.unit)}};
}

Json clearance_json(const Orbit& orbit, Units units) {
  if (!orbit.clearance || !std::isfinite(*orbit.clearance)) return nullptr;
  Json json = unit_json(units, "m", std::vector<double>{*orbit.clearance});
  json["value"] = *orbit.clearance;
  return json;
}

Json place_json(const System& system, const SeenPlace& place, const PlaceSeries& series,
                Units units) {
  Json stops = Json::array();
  std::string name = place.stops.size() > 1 ? "stops" : "stop";
  for (const SeenStop& stop : place.stops) {
    stops.push_back({{"index", stop.index + 1}, {"sense", stop.sense}, {"place", stop.place}});
    name += fmt::format("{} {}", stops.size() > 1 ? " and" : "", stop.index + 1);
  }
  return {{"name", system.stops.size() > 1 ? name : "the stop"},
          {"stops", stops},
          {"length", unit_json(units, "m", series.x)},
          {"speed", unit_json(units, "m/s", series.v)},
          {"t", packed(series.t)},
          {"x", packed(series.x)},
          {"v", packed(series.v)}};
}

// The place that is hit first comes first.
std::vector<SeenPlace> places_seen(const System& system, int first_stop) {
  if (system.stops.empty()) return {};
  std::vector<SeenPlace> places = places_of(system);
  std::erase_if(places, [](const SeenPlace& place) { return place.stops.empty(); });
  const auto has_it = [&](const SeenPlace& place) {
    return std::any_of(place.stops.begin(), place.stops.end(),
                       [&](const SeenStop& stop) { return stop.index == first_stop; });
  };
  std::stable_partition(places.begin(), places.end(), has_it);
  if (places.size() > kMostOrbitPlaces) places.resize(kMostOrbitPlaces);
  return places;
}

std::string stability(const Orbit& orbit) {
  if (!orbit.admissible) return "inadmissible: passes through a stop, or meets it from behind";
  const std::string sticks = orbit.sticks() ? "sticks, " : "";
  if (!orbit.stable) return sticks + "stability open";
  return sticks + (*orbit.stable ? "stable" : "unstable");
}

std::string orbit_name(const Orbit& orbit) {
  return orbit.sticks() ? fmt::format("({},stick) orbit", orbit.period)
                        : fmt::format("({},{}) orbit", orbit.period, orbit.impacts.size());
}

double in_periods(const OrbitInstant& at) { return at.period_index + at.phase / kTurn; }

std::vector<std::string> value_setting(const PageSource& source, std::optional<double> value) {
  if (source.parameter.empty() || !value) return {};
  return {fmt::format("{}={}", source.parameter, *value)};
}

std::string closure_option(const PageSource& source) {
  return source.closure_speed ? fmt::format(" --closure-speed {}", *source.closure_speed) : "";
}

std::string orbit_command(const PageSource& source, const Orbit& orbit,
                          std::vector<std::string> settings) {
  return page_command(source.info, "orbit", settings) + fmt::format(" --period {}", orbit.period) +
         (orbit.sticks() ? "" : fmt::format(" --impacts {}", orbit.impacts.size())) +
         (orbit.admissible ? "" : " --virtual") + closure_option(source);
}

Json stuck_json(const Orbit& orbit, const System& system) {
  Json phases = Json::array();
  for (const StickingPhase& sticking : orbit.sticking) {
    const double from = in_periods(sticking.from);
    phases.push_back({{"stop", sticking.stop + 1},
                      {"from", from},
                      {"to", from + sticking.duration / system.period()}});
  }
  return phases;
}

// "initial.q=[0.1, 0.2]"
std::string list_setting(const char* name, const Vector& numbers) {
  std::string text = fmt::format("{}=[", name);
  for (Eigen::Index i = 0; i < numbers.size(); ++i)
    text += fmt::format("{}{:#}", i > 0 ? "," : "", numbers[i]);
  return text + "]";
}

std::vector<std::string> start_settings(const System& system, const PageMotion& motion) {
  std::vector<std::string> settings = motion.settings;
  const double phase = system.forcing() ? system.forcing()->phase : 0.0;
  const State start = structure_state(system, motion.start, phase);
  settings.push_back(list_setting("initial.q", start.q));
  settings.push_back(list_setting("initial.qdot", start.qdot));
  return settings;
}

// A motion with all of its impacts; the record has none closer to the previous one than the page's
// samples are: these would be invisible, and a chatter has thousands.
struct Followed {
  SimulationRecord record;
  std::vector<Event> impacts;
};
Followed followed(const PageSource& source, const System& system, const State& start,
                  long long periods) {
  Followed followed;
  SimulationRecord& record = followed.record;
  record.system = system;
  SimulationOptions options;
  options.periods = periods;
  options.max_impacts = kMostImpacts;
  options.closure_speed = source.closure_speed.value_or(default_closure_speed(system, start));
  options.stop = source.stop;
  RunListeners listeners;
  const double apart = static_cast<double>(periods) * system.period() / source.most_samples;
  std::vector<double> last(system.stops.size(), -apart);
  listeners.event = [&](const Event& event) {
    if (event.kind == EventKind::kImpact || event.kind == EventKind::kContact) {
      followed.impacts.push_back(event);
      double& before = last[static_cast<std::size_t>(event.stop)];
      if (event.time - before < apart) return;
      before = event.time;
    }
    record.events.push_back(event);
  };
  listeners.sample = [&](const Sample& sample) { record.samples.push_back(sample); };
  listeners.sample_rate = samples_per_period(source, system, periods) / system.period();
  record.run = simulate(system, start, options, listeners);
  return followed;
}

Json motion_json(const PageSource& source, const System& system, const PageMotion& motion) {
  const bool repeats = motion.attractor.period > 0;
  const long long periods = repeats ? motion.attractor.period : kShownPeriods;
  const auto [record, met] = followed(source, system, motion.start, periods);
  if (record.run.outcome == RunOutcome::kInterrupted) return nullptr;
  const double period = system.period();
  Json impacts = Json::array(), stuck = Json::array(), places = Json::array();
  for (std::size_t i = 0; i < std::min(met.size(), kListedImpacts); ++i)
    impacts.push_back(
        {{"stop", met[i].stop + 1}, {"t", met[i].time / period}, {"speed", met[i].speed}});
  const int first = impacts.empty() ? 0 : impacts.front()["stop"].get<int>() - 1;
  const MotionSeen seen = motion_seen(record);
  for (const SeenPlace& shown : places_seen(system, first))
    for (const SeenPlace& place : seen.places) {
      if (place.stops.empty() || place.stops.front().index != shown.stops.front().index) continue;
      PlaceSeries series;
      for (const MotionPoint& point : place.motion)
        // A point at which the velocity jumps belongs to both sides, which have points of their
        // own.
        if (std::isfinite(point.velocity))
          series.add(point.time / period, point.displacement, point.velocity);
        else
          series.gap();
      places.push_back(place_json(system, place, series, source.info.units));
      for (const SeenStop& stop : place.stops)
        for (const TimeSpan& span : stuck_phases(record, stop.index, seen.window))
          stuck.push_back(
              {{"stop", stop.index + 1}, {"from", span.start / period}, {"to", span.end / period}});
    }
  std::vector<double> speeds;
  for (const Event& impact : met) speeds.push_back(impact.speed);
  const std::string name = attractor_title(motion.attractor);
  const std::string shown = repeats
                                ? ""
                                : fmt::format("The first {} of the periods of the {} are shown. ",
                                              periods, motion.settled_in);
  return {{"name",
           repeats ? (name == "no impact" ? "motion without impacts" : name + " motion") : name},
          {"value", json_maybe(motion.value)},
          {"period", repeats ? Json(motion.attractor.period) : Json(nullptr)},
          {"span", {0, periods}},
          {"stability", repeats ? "what the " + motion.settled_in + " settled on" : ""},
          {"admissible", true},
          {"stable", nullptr},
          {"clearance", nullptr},
          {"multipliers", Json::array()},
          {"speed", unit_json(source.info.units, "m/s", speeds)},
          {"impacts", impacts},
          {"stuck", stuck},
          {"places", places},
          {"remark", motion.settled_in == "sweep" ? shown + kFromThere : shown},
          {"command", page_command(source.info, "simulate", start_settings(system, motion)) +
                          fmt::format(" --periods {}", periods) + closure_option(source)}};
}

// The orbit that a motion settled on, solved for from its last repetition.
std::optional<Orbit> settled_orbit(const PageSource& source, const System& system,
                                   const PageMotion& motion) {
  const SettledKind kind = motion.attractor.kind;
  if (kind != SettledKind::kImpacts && kind != SettledKind::kSticks) return {};
  FinderOptions options;
  options.period = motion.attractor.period;
  options.from_closed_form = options.from_random = false;
  options.max_impacts = kMostImpacts;
  options.threads = 1;
  options.stop = source.stop;
  options.closure_speed = source.closure_speed;
  const FoundOrbits found = find_orbits(system, motion.start, options);
  for (const Orbit& orbit : found.orbits)
    if (orbit.admissible && orbit.period == options.period) return orbit;
  return {};
}

}  // namespace

int page_samples(const System& system, long long periods, int most) {
  const double turns = std::max(1.0, system.omega.maxCoeff() / system.forcing()->frequency);
  const double wanted = kSamplesPerTurn * turns * static_cast<double>(periods);
  return static_cast<int>(std::clamp<double>(wanted, kFewest, most));
}

Json page_orbit(const PageSource& source, const System& system, const Orbit& orbit,
                std::optional<double> value) {
  Json impacts = Json::array(), multipliers = Json::array(), places = Json::array();
  for (const OrbitImpact& impact : orbit.impacts) {
    if (impacts.size() == kListedImpacts) break;
    impacts.push_back({{"stop", impact.stop + 1},
                       {"t", impact.period_index + impact.phase / kTurn},
                       {"speed", json_number(impact.speed)}});
  }
  for (const Eigenvalue& multiplier : orbit.multipliers)
    multipliers.push_back(
        {json_number(multiplier.value.real()), json_number(multiplier.value.imag())});
  std::vector<double> speeds;
  for (const OrbitImpact& impact : orbit.impacts) speeds.push_back(impact.speed);
  const int first = orbit.impacts.empty() ? 0 : orbit.impacts.front().stop;
  for (const SeenPlace& place : places_seen(system, first)) {
    PlaceSeries series;
    for (const std::vector<CurveSample>& flight : orbit_curve(
             system, orbit, {system.stops[static_cast<std::size_t>(place.stops.front().index)].row},
             samples_per_period(source, system, orbit.period))) {
      for (const CurveSample& sample : flight)
        series.add(sample.theta / kTurn, sample.displacement, sample.velocity);
      series.gap();
    }
    places.push_back(place_json(system, place, series, source.info.units));
  }
  return {{"name", orbit_name(orbit)},
          {"value", value ? Json(*value) : Json(nullptr)},
          {"period", orbit.period},
          {"stability", stability(orbit)},
          {"admissible", orbit.admissible},
          {"stable", json_maybe(orbit.stable)},
          {"clearance", clearance_json(orbit, source.info.units)},
          {"multipliers", multipliers},
          {"speed", unit_json(source.info.units, "m/s", speeds)},
          {"impacts", impacts},
          {"stuck", stuck_json(orbit, system)},
          {"places", places},
          {"command", orbit_command(source, orbit, value_setting(source, value))}};
}

PageMotion page_motion_of(const PageSource& source, const SweepRow& row) {
  return {attractor_class(row), row.motion.at_start, row.value, value_setting(source, row.value),
          "sweep"};
}

Json page_motion(const PageSource& source, const System& system, const PageMotion& motion) {
  const std::optional<Orbit> orbit = settled_orbit(source, system, motion);
  if (!orbit) return motion_json(source, system, motion);
  Json json = page_orbit(source, system, *orbit, motion.value);
  // A search from the scene's own start may settle on another attractor.
  json["command"] = orbit_command(source, *orbit, start_settings(system, motion));
  return json;
}

std::vector<std::size_t> kept_of(std::size_t count, std::size_t most) {
  std::vector<std::size_t> kept;
  const std::size_t stride = std::max<std::size_t>(1, (count + most - 1) / most);
  for (std::size_t i = 0; i < count; i += stride) kept.push_back(i);
  if (count > 0 && kept.back() + 1 != count) kept.push_back(count - 1);
  return kept;
}

}  // namespace graze
