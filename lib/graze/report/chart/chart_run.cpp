#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "graze/report/chart/charts.hpp"
#include "graze/report/chart/detail/chart_looks.hpp"
#include "graze/report/chart/detail/motion_seen.hpp"
#include "graze/report/chart/detail/probe_panels.hpp"

namespace graze {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
constexpr double kLow = 1.7, kPortrait = 3.6;  // heights of panels, cm
constexpr std::size_t kMostMarks = 3'000;
constexpr std::size_t kMostJumps = 200;         // beyond, their lines fill the panel
constexpr std::size_t kMostPortrayed = 20'000;  // points, which no band can stand for

ChartSeries line_of(std::string title, Look look) {
  return {.title = std::move(title), .look = std::move(look), .x = {}, .y = {}};
}

ChartSeries line_of(const DrawnCurve& curve, std::string title, Look look) {
  ChartSeries series = line_of(std::move(title), std::move(look));
  for (const DrawnPoint& point : curve) add_point(series, point.time, point.value);
  return series;
}

class RunChart {
 public:
  // `explored`: for a page, which thins what is many by what is in view.
  RunChart(const SimulationRecord& record, bool explored)
      : record_(record),
        explored_(explored),
        units_(record.info.units),
        seen_(motion_seen(record)) {
    all_places_ = seen_.places.size();
    seen_.places.resize(std::min(all_places_, kMostRunPlaces));
  }

  Chart made() {
    for (const SeenPlace& place : seen_.places) add_displacement(place);
    add_velocity(seen_.places.front());
    for (const ProbePanel& panel : probe_panels(seen_.probes)) add_probes(panel);
    if (!seen_.forces.empty()) add_forces();
    if (!seen_.rubbing.empty() && !record_.samples.empty()) add_rubbing();
    if (!seen_.energy.empty()) add_energy();
    if (!record_.samples.empty() && !explored_) add_portraits();
    return std::move(chart_);
  }

 private:
  bool several_stops() const { return record_.system.stops.size() > 1; }
  // A modal coordinate is no length.
  std::string length(const SeenPlace& place) const {
    return unit_in(units_, place.is_modal() ? "kg^1/2 m" : "m");
  }
  std::string speed(const SeenPlace& place) const {
    return unit_in(units_, place.is_modal() ? "kg^1/2 m/s" : "m/s");
  }
  // "stop", or "stop 2" where there are several.
  std::string name_of(const SeenStop& stop) const {
    return several_stops() ? fmt::format("stop {}", stop.index + 1) : "stop";
  }
  // As all that is shown of a place, in the few letters that a low panel is high; probes show u and
  // u'. The panels of a page are higher.
  std::string towards(const SeenPlace& place) const {
    if (!explored_ || place.stops.empty()) return place.towards(record_.system);
    return several_stops() ? "towards " + place.name(record_.system) : "towards the stop";
  }
  std::string velocity_name(const SeenPlace& place) const {
    return place.is_modal() ? "rate of q_1\n" : "velocity\n" + towards(place);
  }

  ChartPanel over_time(ChartAxis up) const {
    AxisRange window{seen_.window.start, seen_.window.end};
    if (!(window.span() > 0.0)) window.high = window.low + 1.0;
    return {.x = {.name = "time", .unit = unit_in(units_, "s"), .range = window},
            .y = std::move(up)};
  }
  void put(ChartPanel panel) { chart_.rows.push_back({std::move(panel)}); }

  static ChartSeries marks(const SeenPlace& place) {
    ChartSeries series = marks_of({.id = "impacts",
                                   .title = "impact",
                                   .colour = kVermillion,
                                   .mark = MarkShape::kDot,
                                   .size = 0.55});
    // Marks shrink with their number.
    const auto count = static_cast<double>(std::max<std::size_t>(place.impacts.size(), 1));
    series.look.size = std::clamp(0.55 * std::sqrt(40.0 / count), 0.18, 0.55);
    return series;
  }

  // The part of a motion in its portrait: the end of a long one, which would cover the beginning.
  static std::span<const MotionPoint> portrayed(const SeenPlace& place) {
    return std::span(place.motion).last(std::min(place.motion.size(), kMostPortrayed));
  }

  static AxisRange displacements(std::span<const MotionPoint> motion) {
    AxisRange range;
    for (const MotionPoint& point : motion) range.include(point.displacement);
    return range;
  }

  // Shows stops near the motion, with the space behind them shaded; one far away, which would
  // flatten the motion, is only named.
  void add_stops(const SeenPlace& place, const AxisRange& motion, bool is_upright,
                 ChartPanel& panel) {
    AxisRange& range = (is_upright ? panel.y : panel.x).range;
    for (const SeenStop& stop : place.stops) {
      if (!is_near(stop, motion)) {
        if (is_upright)
          panel.heading +=
              fmt::format("{}{} at {} {}", panel.heading.empty() ? "" : ", ", name_of(stop),
                          length_text(stop.place), stop.sense > 0.0 ? "↑" : "↓");
        continue;
      }
      range.include(stop.place);
      panel.fills.push_back(behind(stop, is_upright));
      if (is_upright && several_stops()) name_along(stop, panel);
    }
  }

  std::string length_text(double place) const {
    const AxisUnit unit = axis_unit(unit_in(units_, "m"), std::abs(place));
    return fmt::format("{}{:.4g}{}{}", place < 0.0 ? "−" : "", unit.factor * std::abs(place),
                       unit.unit.empty() ? "" : " ", unit.unit);
  }
  void name_along(const SeenStop& stop, ChartPanel& panel) const {
    ChartName name{ChartName::Of::kCurve, name_of(stop), {}};
    for (const double part : {0.97, 0.9, 0.8, 0.7, 0.5, 0.3, 0.1})
      name.places.emplace_back(panel.x.range.low + part * panel.x.range.span(), stop.place);
    panel.names.push_back(std::move(name));
  }

  void add_stuck(const SeenPlace& place, ChartPanel& panel) const {
    for (const StuckPhase& phase : place.stuck)
      panel.fills.push_back({false, phase.time.start, phase.time.end, "stuck", kStuckShade});
  }

  void add_displacement(const SeenPlace& place) {
    ChartPanel panel =
        over_time({.name = place.is_modal() ? "first mode q_1\n" : "displacement\n" + towards(place),
                   .unit = length(place)});
    const AxisRange motion = displacements(place.motion);
    panel.y.range = motion;
    if (record_.samples.empty()) panel.y.range.include(0.0);
    if (chart_.rows.empty() && all_places_ > seen_.places.size())
      panel.heading = fmt::format("the first {} of {} places", seen_.places.size(), all_places_);
    add_stuck(place, panel);
    add_stops(place, motion, true, panel);
    panel.y.range.settle(0.1);
    if (record_.samples.empty()) {
      panel.remark = "no samples were recorded";
    } else {
      ChartSeries line = line_of("", {.id = "displacement", .colour = kBlue, .width = 1.2});
      for (const MotionPoint& point : place.motion) add_point(line, point.time, point.displacement);
      panel.series.push_back(std::move(line));
    }
    ChartSeries touches = marks(place);
    const std::size_t stride = explored_ ? 1 : place.impacts.size() / kMostMarks + 1;
    for (std::size_t k = 0; k < place.impacts.size(); k += stride)
      add_point(touches, place.impacts[k].time, place.impacts[k].place);
    if (!touches.x.empty()) panel.series.push_back(std::move(touches));
    put(std::move(panel));
  }

  static AxisRange velocities(std::span<const MotionPoint> motion) {
    AxisRange range;
    for (const MotionPoint& point : motion) range.include(point.velocity);
    range.settle(0.08);
    return range;
  }

  void add_velocity(const SeenPlace& place) {
    ChartPanel panel = over_time(
        {.name = velocity_name(place), .unit = speed(place), .range = velocities(place.motion)});
    panel.levels = {0.0};
    add_stuck(place, panel);
    ChartSeries line = line_of("", {.id = "velocity", .colour = kBlue, .width = 1.2});
    for (const MotionPoint& point : place.motion) add_point(line, point.time, point.velocity);
    if (!record_.samples.empty()) panel.series.push_back(std::move(line));
    ChartSeries jumps =
        line_of("", {.id = "jumps", .colour = kVermillion, .dashes = {6, 4}, .width = 0.8});
    for (const SeenImpact& impact : place.impacts) {
      add_point(jumps, impact.time, impact.before);
      add_point(jumps, impact.time, impact.after);
      add_point(jumps, kGap, kGap);
    }
    if (!jumps.x.empty() && (explored_ || place.impacts.size() <= kMostJumps))
      panel.series.push_back(std::move(jumps));
    put(std::move(panel));
  }

  void add_probes(const ProbePanel& probes) {
    ChartPanel panel = over_time({.name = probes.name(), .unit = unit_in(units_, probes.si_unit)});
    panel.levels = {0.0};
    const std::size_t shown = std::min(probes.probes.size(), curve_colours().size());
    for (std::size_t k = 0; k < shown; ++k) {
      const SeenProbe& probe = probes.probes[k];
      Look look = curve_look(static_cast<std::size_t>(probe.number - 1));
      look.id = fmt::format("probe{}", probe.number);
      look.width = 1.2;
      panel.series.push_back(line_of(probe.curve, fmt::format("probe {}", probe.number), look));
    }
    if (shown < probes.probes.size())
      panel.heading = fmt::format("the first {} of {} probes", shown, probes.probes.size());
    put(std::move(panel));
  }

  void add_forces() {
    ChartPanel panel =
        over_time({.name = "contact\nforce", .unit = unit_in(units_, "N"), .from_zero = true});
    panel.levels = {0.0};
    panel.height = kLow;
    for (const SeenForce& seen : seen_.forces) {
      const auto stop = static_cast<std::size_t>(seen.stop);
      panel.series.push_back(
          line_of(seen.force, several_stops() ? fmt::format("force at stop {}", stop + 1) : "",
                  {.id = fmt::format("force{}", stop + 1),
                   .colour = curve_colours()[stop % curve_colours().size()],
                   .width = 1.2}));
    }
    put(std::move(panel));
  }

  void add_rubbing() {
    ChartPanel panel = over_time({.name = "friction\nforce", .unit = unit_in(units_, "N")});
    panel.levels = {0.0};
    const bool several = seen_.rubbing.size() > 1;
    for (std::size_t k = 0; k < std::min(seen_.rubbing.size(), curve_colours().size()); ++k)
      panel.series.push_back(line_of(seen_.rubbing[k],
                                     several ? fmt::format("force of friction {}", k + 1) : "",
                                     {.id = fmt::format("friction{}", k + 1),
                                      .colour = curve_colours()[k],
                                      .width = 1.2}));
    put(std::move(panel));
  }

  void add_energy() {
    const bool has_work = seen_.energy.size() > 1;
    ChartPanel panel = over_time({.name = has_work ? "energy,\nwork" : "energy",
                                  .unit = unit_in(units_, "J"),
                                  .from_zero = true});
    panel.levels = {0.0};
    for (const EnergyTerm& term : seen_.energy) {
      // The energy, drawn first, remains visible below a term that coincides with it.
      const bool is_first = &term == seen_.energy.data();
      panel.series.push_back(
          line_of(term.curve,
                  !has_work  ? ""
                  : is_first ? term.name
                             : "work of " + term.name,
                  {.id = term.name, .colour = term.colour, .width = is_first ? 2.0 : 1.2}));
    }
    if (has_work && seen_.window.start > 0.0)
      panel.heading = "work since " + time_text(seen_.window.start);
    put(std::move(panel));
  }

  std::string time_text(double time) const {
    const AxisUnit unit = axis_unit(
        unit_in(units_, "s"), std::max(std::abs(seen_.window.start), std::abs(seen_.window.end)));
    return fmt::format("{:.5g} {}", unit.factor * time, unit.unit);
  }

  // Portraits of the first two places.
  void add_portraits() {
    std::vector<ChartPanel> row;
    const std::size_t count = std::min<std::size_t>(seen_.places.size(), 2);
    for (std::size_t i = 0; i < count; ++i) row.push_back(portrait(seen_.places[i], count == 1));
    chart_.rows.push_back(std::move(row));
  }

  ChartPanel portrait(const SeenPlace& place, bool is_alone) {
    const std::string name =
        place.is_modal() ? "first mode q_1"
                         : (is_alone ? "displacement " : "") +
                               (place.stops.empty() ? "at " : std::string("towards ")) +
                               place.name(record_.system);
    const std::span<const MotionPoint> motion = portrayed(place);
    ChartPanel panel{
        .x = {.name = name, .unit = length(place), .range = displacements(motion)},
        .y = {.name = is_alone || place.stops.empty() ? velocity_name(place) : "velocity\n→ stop",
              .unit = speed(place),
              .range = velocities(motion)},
        .levels = {0.0},
        .height = kPortrait};
    add_stops(place, displacements(motion), false, panel);
    panel.x.range.settle(0.06);
    if (motion.size() < place.motion.size() && motion.front().time > 0.0)
      panel.heading = "since " + time_text(motion.front().time);
    ChartSeries line = line_of("", {.id = "portrait", .colour = kBlue, .width = 1.0});
    for (const MotionPoint& point : motion) add_point(line, point.displacement, point.velocity);
    panel.series.push_back(std::move(line));
    ChartSeries approaches = marks(place);
    for (std::size_t k = 0; k < place.impacts.size(); k += place.impacts.size() / kMostMarks + 1)
      if (place.impacts[k].time >= motion.front().time)
        add_point(approaches, place.impacts[k].place, place.impacts[k].before);
    if (!approaches.x.empty()) panel.series.push_back(std::move(approaches));
    add_rests(place, panel);
    return panel;
  }

  // Where the motion sticks the portrait has a point.
  static void add_rests(const SeenPlace& place, ChartPanel& panel) {
    std::vector<double> rests;
    for (const StuckPhase& phase : place.stuck)
      if (!std::isnan(phase.place)) rests.push_back(phase.place);
    std::sort(rests.begin(), rests.end());
    rests.erase(std::unique(rests.begin(), rests.end()), rests.end());
    ChartSeries series = marks_of({.id = "rest",
                                   .title = "at rest on the stop",
                                   .colour = kStuckShade,
                                   .mark = MarkShape::kDot});
    for (const double at : rests) add_point(series, at, 0.0);
    if (!rests.empty()) panel.series.push_back(std::move(series));
  }

  const SimulationRecord& record_;
  bool explored_;
  Units units_;
  MotionSeen seen_;
  std::size_t all_places_ = 0;
  Chart chart_{.title = "Motion", .rows = {}};
};

}  // namespace

Chart motion_chart(const SimulationRecord& record) { return RunChart(record, false).made(); }

Chart explored_chart(const SimulationRecord& record) { return RunChart(record, true).made(); }

}  // namespace graze
