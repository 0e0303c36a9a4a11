#include <fmt/format.h>

#include <algorithm>

#include "graze/record/names/motion_names.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/json/detail/json_page.hpp"
#include "graze/report/page/detail/page_plane.hpp"
#include "graze/report/page/page.hpp"
#include "graze/report/page/page_tables.hpp"

namespace graze {
namespace {

std::string span_text(const OrbitLocus& locus, double OrbitLocusPoint::*of,
                      const std::string& unit) {
  const auto [low, high] = std::minmax_element(
      locus.points.begin(), locus.points.end(),
      [of](const OrbitLocusPoint& a, const OrbitLocusPoint& b) { return a.*of < b.*of; });
  return measured_text((*low).*of, unit) + " to " + measured_text((*high).*of, unit);
}

PageTable loci_table(const LociRecord& record) {
  const OrbitLoci& traced = record.traced;
  PageTable table{"Loci",
                  {"locus", "kind", "orbit", plain_text(parameter_title(traced.first)),
                   plain_text(parameter_title(traced.second)), "ends"},
                  {}};
  for (const OrbitLocus& locus : traced.loci) {
    const bool closed = locus.ends[0] == OrbitLocusEnd::kClosed;
    table.rows.push_back(
        {std::to_string(locus.id), label_of(locus.kind),
         orbit_label(locus.pattern.period, locus.pattern.impacts(), locus.sticks()),
         span_text(locus, &OrbitLocusPoint::value, record.unit),
         span_text(locus, &OrbitLocusPoint::second, record.second_unit),
         closed ? name_of(locus.ends[0]) : name_of(locus.ends[0]) + ", " + name_of(locus.ends[1])});
  }
  return table;
}

}  // namespace

void write_page(const std::string& file, const LociRecord& record, const Scene& scene) {
  const Chart chart = explored_chart(record);
  const Json view = chart_view(chart, record.info, record.outcome, record.warnings, {}, {});
  PageCells cells;
  if (record.regions) {
    const StableRegions& regions = *record.regions;
    cells.message = [&](std::size_t i) -> const std::string& { return regions.places[i].message; };
    Plane plane;
    plane.x.name = record.traced.first;
    plane.y.name = record.traced.second;
    cells.command = cell_command_json(page_command(record.info, "orbit", {}),
                                      fmt::format(" --period {}", regions.period), plane, scene);
  }
  write_plane(file, chart, view, record.regions ? &cells : nullptr, &record.traced,
              {loci_table(record)});
}

}  // namespace graze
