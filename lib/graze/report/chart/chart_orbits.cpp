#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"
#include "graze/orbit/detail/orbit_curve.hpp"
#include "graze/record/records.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/chart/detail/motion_seen.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostOrbits = 8;
constexpr int kChartSamplesPerPeriod = 400, kExploredSamplesPerPeriod = 2000;

using Flights = std::vector<std::vector<CurveSample>>;

const Look& line_look(const Orbit& orbit) {
  const char* id = !orbit.admissible      ? "virtual"
                   : !orbit.stable        ? "open"
                   : orbit.stable == true ? "stable"
                                          : "unstable";
  const std::span<const Look> looks = line_looks();
  return *std::find_if(looks.begin(), looks.end(), [&](const Look& look) { return look.id == id; });
}

// "(1,1) stable, v = 0.1353 m/s", with several impacts "(2,3) stable, v ≤ 0.1353 m/s"
std::string heading_of(const Orbit& orbit, Units units) {
  const std::string name = orbit.meets_stops()
                               ? fmt::format("({},{})", orbit.period, orbit.impacts.size())
                               : std::string("no impact");
  std::string text = name + (orbit.sticks() ? " sticks, " : " ") + line_look(orbit).title;
  if (orbit.impacts.empty()) return text;
  double fastest = orbit.impacts.front().speed;
  for (const OrbitImpact& impact : orbit.impacts) fastest = std::max(fastest, impact.speed);
  return text + fmt::format(", v {} {}{:.4g}{}", orbit.impacts.size() == 1 ? "=" : "≤",
                            fastest < 0.0 ? "−" : "", std::abs(fastest), unit_behind(units, "m/s"));
}

// How an orbit is drawn: `thing` is its index among those of a page, -1 of a picture.
struct DrawnOrbit {
  Look look;
  std::string title;  // of its curve
  int samples = kChartSamplesPerPeriod;
  int thing = -1;
};

DrawnOrbit in_picture(const Orbit& orbit) {
  DrawnOrbit drawn{line_look(orbit), line_look(orbit).title};
  drawn.look.width = 1.5;
  return drawn;
}

// One row of panels of an orbit: its motion over time, and its phase portrait.
class OrbitRow {
 public:
  // `end`: of the axis of time, s.
  OrbitRow(const System& system, const Orbit& orbit, const SeenPlace& place, double end,
           Units units, DrawnOrbit drawn)
      : orbit_(orbit),
        frequency_(orbit.timed(system).forcing()->frequency),
        whole_(kTurn * orbit.period),
        drawn_(std::move(drawn)) {
    const std::string unit = unit_in(units, place.is_modal() ? "kg^1/2 m" : "m");
    const std::string speed_unit = unit_in(units, place.is_modal() ? "kg^1/2 m/s" : "m/s");
    const std::string where = place.towards(system);
    motion_ = {{.name = "time", .unit = unit_in(units, "s")},
               {.name = "displacement\n" + where, .unit = unit}};
    motion_.x.range = {0.0, end};
    portrait_ = {{.name = place.stops.empty() ? where : "towards " + place.name(system),
                  .unit = unit},
                 {.name = "velocity\n" + where, .unit = speed_unit}};
    motion_.height = portrait_.height = 3.0;
    motion_.heading = heading_of(orbit, units);
    portrait_.levels = {0.0};
    flights_ = orbit_curve(system, orbit, {place.row}, drawn_.samples);
    add_curves();
    add_impacts();
    add_stuck();
    for (const int friction : place.frictions) add_rests(friction);
    for (const SeenStop& seen : place.stops) add_stop(seen);
    if (drawn_.thing < 0) return;
    for (ChartPanel* panel : {&motion_, &portrait_})
      for (ChartSeries& series : panel->series) series.of.assign(series.x.size(), drawn_.thing);
  }

  std::vector<ChartPanel> panels() const { return {motion_, portrait_}; }

 private:
  // A curve that was cut at the end of the orbit's last period continues at its start.
  void add_curves() {
    ChartSeries course{drawn_.title, drawn_.look, true, false, {}, {}};
    ChartSeries portrait = course;
    const double gap = std::numeric_limits<double>::quiet_NaN();
    for (const double shift : {whole_, 0.0}) {
      for (const auto& flight : flights_)
        for (const CurveSample& sample : flight) {
          const double theta = sample.theta - shift;
          if (theta < 0.0 || theta > whole_) continue;
          course.x.push_back(theta / frequency_);
          course.y.push_back(sample.displacement);
        }
      course.x.push_back(gap), course.y.push_back(gap);
    }
    for (const auto& flight : flights_) {
      for (const CurveSample& sample : flight) {
        portrait.x.push_back(sample.displacement);
        portrait.y.push_back(sample.velocity);
      }
      portrait.x.push_back(gap), portrait.y.push_back(gap);
    }
    motion_.series.push_back(course);
    portrait_.series.push_back(portrait);
  }

  // The flight that ends at an impact is joined, across the jump of its velocity, with the next.
  void add_impacts() {
    if (orbit_.impacts.empty()) return;
    // On a page the colours are those of the orbits.
    ChartSeries marks{
        "impact",
        {.colour = drawn_.thing < 0 ? kVermillion : kBlack, .mark = MarkShape::kDot, .size = 0.55},
        false,
        true,
        {},
        {}};
    ChartSeries jumps{
        "", {.colour = drawn_.look.colour, .dashes = {3, 4}, .width = 1.0}, true, false, {}, {}};
    ChartSeries approaches = marks;
    for (std::size_t k = 0; k < flights_.size(); ++k) {
      const CurveSample &before = flights_[k].back(),
                        &after = flights_[(k + 1) % flights_.size()].front();
      if (before.velocity == after.velocity) continue;
      double theta = std::fmod(before.theta, whole_);
      marks.x.push_back((theta < 0.0 ? theta + whole_ : theta) / frequency_);
      marks.y.push_back(before.displacement);
      approaches.x.push_back(before.displacement);
      approaches.y.push_back(before.velocity);
      for (const double velocity :
           {before.velocity, after.velocity, std::numeric_limits<double>::quiet_NaN()}) {
        jumps.x.push_back(before.displacement);
        jumps.y.push_back(velocity);
      }
    }
    // A chatter that completes has infinitely many impacts: crowded marks are smaller.
    if (marks.x.size() > 40) marks.look.size = approaches.look.size = 0.3;
    motion_.series.push_back(marks);
    portrait_.series.push_back(jumps);
    portrait_.series.push_back(approaches);
  }

  void add_stuck() {
    for (const StickingPhase& sticking : orbit_.sticking) {
      const double from = sticking.from.phase + kTurn * sticking.from.period_index;
      shade(from, from + sticking.duration * frequency_);
    }
  }

  // Where dry friction sticks, up to what it does next.
  void add_rests(int friction) {
    std::vector<OrbitRubbing> own;
    for (const OrbitRubbing& one : orbit_.rubbing)
      if (one.friction == friction) own.push_back(one);
    for (std::size_t k = 0; k < own.size(); ++k) {
      if (own[k].what != Rubs::kSticks) continue;
      const auto phase = [](const OrbitRubbing& one) {
        return one.at.phase + kTurn * one.at.period_index;
      };
      const double from = phase(own[k]), to = phase(own[(k + 1) % own.size()]);
      shade(from, k + 1 < own.size() ? to : to + whole_);
    }
  }

  // From one phase to another, as far as the orbit's periods go.
  void shade(double from, double to) {
    for (const double shift : {whole_, 0.0})
      if (to > shift && from - shift < whole_)
        motion_.fills.push_back({false, std::max(from - shift, 0.0) / frequency_,
                                 std::min(to - shift, whole_) / frequency_, "stuck", kStuckShade});
  }

  void add_stop(const SeenStop& stop) {
    motion_.fills.push_back(behind(stop, true));
    portrait_.fills.push_back(behind(stop, false));
  }

  const Orbit& orbit_;
  double frequency_, whole_;
  DrawnOrbit drawn_;
  Flights flights_;
  ChartPanel motion_, portrait_;
};

// Makes both axes of displacement include the stops, if they are not far away.
void set_ranges(Chart& chart, const std::vector<SeenStop>& stops) {
  AxisRange displacement, velocity;
  for (const std::vector<ChartPanel>& row : chart.rows)
    for (std::size_t i = 0; i < row[1].series.front().x.size(); ++i) {
      displacement.include(row[1].series.front().x[i]);
      velocity.include(row[1].series.front().y[i]);
    }
  const double largest = std::max(std::abs(displacement.low), std::abs(displacement.high));
  for (const SeenStop& stop : stops)
    if (std::abs(stop.place) <= 3.0 * largest) displacement.include(stop.place);
  displacement.settle(0.08);
  velocity.settle(0.08);
  // All orbits are drawn to one scale.
  for (std::vector<ChartPanel>& row : chart.rows) {
    row[0].y.range = row[1].x.range = displacement;
    row[1].y.range = velocity;
  }
}

Chart without_orbits(const OrbitRecord& record) {
  ChartPanel none{{.name = "time", .unit = unit_in(record.info.units, "s")},
                  {.name = "displacement", .unit = unit_in(record.info.units, "m")}};
  none.remark = "no orbit was found";
  return {"Periodic orbits", {{none}}};
}

// The place of the first impact among the first `count` orbits, s of their longest period.
struct OrbitsSeen {
  SeenPlace place;
  double end = 0.0;
};

OrbitsSeen orbits_seen(const OrbitRecord& record, std::size_t count) {
  const std::vector<Orbit>& orbits = record.found.orbits;
  int stop = 0;
  double end = 0.0;
  for (std::size_t i = count; i-- > 0;) {
    if (!orbits[i].impacts.empty()) stop = orbits[i].impacts.front().stop;
    end = std::max(end, orbits[i].period * orbits[i].timed(record.system).period());
  }
  const std::vector<SeenPlace> places = places_of(record.system);
  const auto at_stop = std::find_if(places.begin(), places.end(), [&](const SeenPlace& any) {
    return std::any_of(any.stops.begin(), any.stops.end(),
                       [&](const SeenStop& seen) { return seen.index == stop; });
  });
  return {at_stop == places.end() ? places.front() : *at_stop, end};
}

}  // namespace

Chart chart_of(const OrbitRecord& record) {
  const std::vector<Orbit>& orbits = record.found.orbits;
  const std::size_t shown = std::min(orbits.size(), kMostOrbits);
  if (shown == 0) return without_orbits(record);
  Chart chart{"Periodic orbits", {}};
  const OrbitsSeen seen = orbits_seen(record, shown);
  for (std::size_t i = 0; i < shown; ++i)
    chart.rows.push_back(OrbitRow(record.system, orbits[i], seen.place, seen.end, record.info.units,
                                  in_picture(orbits[i]))
                             .panels());
  if (shown < orbits.size())
    chart.rows.front()[1].heading = fmt::format("the first {} of {} orbits", shown, orbits.size());
  set_ranges(chart, seen.place.stops);
  return chart;
}

Chart explored_chart(const OrbitRecord& record) {
  const std::vector<Orbit>& orbits = record.found.orbits;
  if (orbits.empty()) return without_orbits(record);
  const OrbitsSeen seen = orbits_seen(record, orbits.size());
  Chart all{"Periodic orbits", {}};
  ChartThings things;
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    const std::string of = fmt::format("orbit {}", i + 1);
    DrawnOrbit drawn{line_look(orbits[i]), of + ", " + heading_of(orbits[i], record.info.units),
                     kExploredSamplesPerPeriod, static_cast<int>(i)};
    drawn.look.colour = curve_colours()[i % curve_colours().size()];
    things.kinds.push_back({drawn.title, of, ""});
    things.kind.push_back(static_cast<int>(i));
    all.rows.push_back(OrbitRow(record.system, orbits[i], seen.place, seen.end, record.info.units,
                                std::move(drawn))
                           .panels());
  }
  set_ranges(all, seen.place.stops);
  // All orbits in one phase plane, and below it over one axis of time.
  ChartPanel portrait = all.rows.front()[1], motion = all.rows.front()[0];
  for (std::size_t i = 1; i < all.rows.size(); ++i) {
    const std::vector<ChartPanel>& row = all.rows[i];
    motion.series.insert(motion.series.end(), row[0].series.begin(), row[0].series.end());
    portrait.series.insert(portrait.series.end(), row[1].series.begin(), row[1].series.end());
  }
  if (orbits.size() > 1)
    std::erase_if(motion.fills, [](const ChartFill& fill) { return !fill.is_upright; });
  portrait.height = 6.0;
  motion.heading = "";
  Chart chart{all.title, {{portrait}, {motion}}, {"impact", "behind the stop"}};
  chart.things = std::move(things);
  return chart;
}

}  // namespace graze
