#include <algorithm>
#include <cmath>

#include "graze/record/names/plane_names.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/chart/detail/motion_seen.hpp"

namespace graze {
namespace {

struct QuantityLook {
  ComparedQuantity quantity;
  const char* colour;
  MarkShape mark;
  bool open;
};
constexpr QuantityLook kLooks[] = {
    {ComparedQuantity::kFirstTime, kBlue, MarkShape::kDot, false},
    {ComparedQuantity::kFirstSpeed, kSky, MarkShape::kCircle, true},
    {ComparedQuantity::kDisplacement, kGreen, MarkShape::kUp, false},
    {ComparedQuantity::kVelocity, kOrange, MarkShape::kDiamond, false},
    {ComparedQuantity::kEnergy, kVermillion, MarkShape::kSquare, false},
    {ComparedQuantity::kTaken, kPurple, MarkShape::kDown, false}};

ChartSeries curve_of(const MotionSeen& seen, double MotionPoint::*part, const std::string& name,
                     std::size_t i) {
  ChartSeries series{
      as_markup(name), {.colour = i == 0 ? kBlue : kVermillion, .width = 1.4}, true, false, {}, {}};
  if (i > 0) series.look.dashes = {8, 4};
  for (const MotionPoint& point : seen.places.front().motion) {
    series.x.push_back(point.time);
    series.y.push_back(point.*part);
  }
  return series;
}

// Shades the space behind the stops of the first motion; those of the other one, if different, are
// lines, dashed as its curves.
void add_stops(const std::vector<MotionSeen>& seen, ChartPanel& panel) {
  double largest = 0.0;
  for (const ChartSeries& series : panel.series)
    for (const double value : series.y)
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  const std::vector<SeenStop>& own = seen.front().places.front().stops;
  const auto is_near = [&](const SeenStop& stop) { return std::abs(stop.place) <= 1.5 * largest; };
  for (const SeenStop& stop : own)
    if (is_near(stop)) {
      panel.fills.push_back(behind(stop, true));
      panel.levels.push_back(stop.place);
    }
  for (const SeenStop& stop : seen.back().places.front().stops)
    if (is_near(stop) && std::none_of(own.begin(), own.end(),
                                      [&](const SeenStop& one) { return one.place == stop.place; }))
      panel.series.push_back({"stop of the other",
                              {.colour = kVermillion, .dashes = {8, 4}, .width = 1.6},
                              true,
                              false,
                              {seen.back().window.start, seen.back().window.end},
                              {stop.place, stop.place}});
}

Chart motions_chart(const ComparisonRecord& record) {
  std::vector<MotionSeen> seen;
  for (const SimulationRecord& run : record.runs) seen.push_back(motion_seen(run));
  const Units units = record.info.units;
  const ChartAxis time{.name = "time", .unit = unit_in(units, "s")};
  ChartPanel displacement{time, {.name = "displacement\n→ stop", .unit = unit_in(units, "m")}};
  ChartPanel velocity{time, {.name = "velocity\n→ stop", .unit = unit_in(units, "m/s")}};
  displacement.height = velocity.height = 3.6;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    displacement.series.push_back(
        curve_of(seen[i], &MotionPoint::displacement, record.names[i], i));
    velocity.series.push_back(curve_of(seen[i], &MotionPoint::velocity, record.names[i], i));
  }
  add_stops(seen, displacement);
  velocity.levels.push_back(0.0);
  return {"Motions side by side", {{displacement}, {velocity}}};
}

// Sizes of the differences from N modes to the next number of them.
Chart modes_chart(const ComparisonRecord& record) {
  ChartPanel panel{{.name = "number of modes N, compared with the next"},
                   {.name = "size of the difference", .scale = AxisScale::kLog}};
  panel.height = 6.0;
  for (const QuantityLook& look : kLooks) {
    ChartSeries series{title_of(look.quantity),
                       {.colour = look.colour, .width = 1.2, .mark = look.mark, .open = look.open},
                       true,
                       true,
                       {},
                       {}};
    for (std::size_t i = 0; i < record.differences.size(); ++i) {
      const double size = std::abs(compared_value(record.differences[i], look.quantity));
      // A difference of zero has no place on a logarithmic axis.
      if (!(size > 0.0)) continue;
      series.x.push_back(record.modes[i]);
      series.y.push_back(size);
    }
    if (!series.x.empty()) panel.series.push_back(series);
  }
  if (panel.series.empty()) panel.remark = "no difference";
  return {"Numbers of modes side by side", {{panel}}};
}

}  // namespace

Chart chart_of(const ComparisonRecord& record) {
  return record.modes.empty() ? motions_chart(record) : modes_chart(record);
}

}  // namespace graze
