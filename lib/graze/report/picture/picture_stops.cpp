#include "graze/report/picture/detail/picture_stops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

constexpr double kNameRoom = 0.16;  // of the axis

}  // namespace

StopMarks::StopMarks(const std::vector<SeenStop>& stops, const AxisRange& motion,
                     const AxisUnit& unit, bool named, Units units)
    : unit_(unit), named_(named), units_(units) {
  const double reach = 4.0 * std::max(motion.empty() ? 0.0 : motion.span(), 0.25 * largest(motion));
  for (const SeenStop& stop : stops) {
    const bool near =
        motion.empty() || (at(stop) >= motion.low - reach && at(stop) <= motion.high + reach);
    (near ? near_ : far_).push_back(stop);
  }
}

void StopMarks::include(AxisRange& range) const {
  for (const SeenStop& stop : near_) range.include(at(stop));
}

void StopMarks::make_room(AxisRange& range) const {
  const double span = range.span();
  for (const SeenStop& stop : far_)
    (stop.sense > 0.0 ? range.high : range.low) += stop.sense * kNameRoom * span;
}

AxisRange StopMarks::between(const AxisRange& range) const {
  AxisRange free = range;
  for (const SeenStop& stop : near_) {
    if (stop.sense > 0.0)
      free.high = std::min(free.high, at(stop));
    else
      free.low = std::max(free.low, at(stop));
  }
  return free;
}

std::string StopMarks::name(const SeenStop& stop) const {
  return named_ ? fmt::format("stop {}", stop.index + 1) : "stop";
}

void StopMarks::draw(GnuplotScript& script, const AxisRange& range, double spacing,
                     std::vector<std::string>& layers) const {
  std::vector<CurveLabel> labels;
  for (const SeenStop& stop : near_) {
    script.command(
        fmt::format("set object rectangle from graph 0, first {:.9g} to graph 1, first {:.9g} "
                    "behind fillcolor rgb '{}' fillstyle solid noborder",
                    at(stop), edge(stop, range), kStopShade));
    layers.push_back(fmt::format("{:.9g} with lines lw 2 lc rgb '{}'", at(stop), kBlack));
    if (named_) labels.push_back({at(stop), name(stop), kBlack});
  }
  label_curves(script, labels, range, spacing);
  double above = 0.0, below = 0.0;
  for (const SeenStop& stop : far_) {
    double& taken = stop.sense > 0.0 ? above : below;
    const double height = (taken + 0.5 * kNameRoom) / (1.0 + kNameRoom);
    taken += kNameRoom;
    const AxisUnit unit = axis_unit(unit_in(units_, "m"), std::abs(stop.place));
    script.command(fmt::format(
        "set label '{} at {}{:.4g} {} {}' at graph 0.99, graph {:.4g} right font medium",
        name(stop), stop.place < 0.0 ? "−" : "", unit.factor * std::abs(stop.place), unit.unit,
        stop.sense > 0.0 ? "↑" : "↓", stop.sense > 0.0 ? 1.0 - height : height));
  }
}

void StopMarks::draw_across(GnuplotScript& script, const AxisRange& range) const {
  for (const SeenStop& stop : near_) {
    script.command(
        fmt::format("set object rectangle from first {:.9g}, graph 0 to first {:.9g}, graph 1 "
                    "behind fillcolor rgb '{}' fillstyle solid noborder",
                    at(stop), edge(stop, range), kStopShade));
    script.command(
        fmt::format("set arrow from first {:.9g}, graph 0 to first {:.9g}, graph 1 "
                    "nohead back lw 2 lc rgb '{}'",
                    at(stop), at(stop), kBlack));
  }
}

}  // namespace graze
