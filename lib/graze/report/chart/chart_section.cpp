#include <fmt/format.h>

#include <map>

#include "graze/report/chart/charts.hpp"
#include "graze/report/chart/detail/chart_looks.hpp"
#include "graze/report/chart/detail/motion_seen.hpp"

namespace graze {

Chart section_chart(const SimulationRecord& record) {
  constexpr double kHeight = 7.0;  // cm
  const RunSection& section = *record.section;
  const bool is_of_impacts = section.kind() == DiagramSection::kImpact;
  const std::size_t stops = record.system.stops.size();
  // Stops at one place have the same points.
  std::map<int, ChartSeries> seen;
  const auto add = [&](int stop) {
    const auto index = static_cast<std::size_t>(stop);
    Look look = dot_look("periodic");
    look.id = fmt::format("section{}", stop + 1);
    look.title.clear();
    look.colour = curve_colours()[index % curve_colours().size()];
    // Dots shrink with their number.
    look.size *= crowded_dot_size(section.points().size(), 0.35);
    ChartSeries series = dots_of(look);
    seen.emplace(stop, std::move(series));
  };
  if (is_of_impacts)
    for (std::size_t i = 0; i < stops; ++i) add(static_cast<int>(i));
  else
    for (const SeenPlace& place : places_of(record.system))
      if (!place.stops.empty()) add(place.stops[0].index);
  for (const SectionPoint& point : section.points())
    if (const auto at = seen.find(point.stop); at != seen.end())
      add_point(at->second, point.across, point.up);
  std::erase_if(seen, [](const auto& entry) { return entry.second.x.empty(); });
  // With several stops the axis says that the quantity is towards the stop concerned.
  const std::string towards =
      stops > 1 && seen.size() == 1 ? " towards stop 1" : " towards the stop";
  const Units units = record.info.units;
  ChartPanel panel;
  panel.height = kHeight;
  panel.x = {.name = is_of_impacts ? "forcing phase at the impact" : "displacement" + towards,
             .unit = unit_in(units, is_of_impacts ? "rad" : "m")};
  panel.y = {.name = is_of_impacts ? "impact speed" : "velocity" + towards,
             .unit = unit_in(units, "m/s"),
             .from_zero = is_of_impacts};
  if (seen.empty()) panel.remark = "no point of the section";
  for (auto& [stop, series] : seen) {
    if (seen.size() > 1) series.title = fmt::format("stop {}", stop + 1);
    panel.series.push_back(std::move(series));
  }
  return {.title = "Poincaré section", .rows = {{std::move(panel)}}};
}

}  // namespace graze
