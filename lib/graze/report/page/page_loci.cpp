#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "graze/record/names/detail/kind_names.hpp"
#include "graze/record/names/detail/sweep_names.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/chart/detail/region_tints.hpp"
#include "graze/report/json/detail/json_page.hpp"
#include "graze/report/page/detail/page.hpp"
#include "graze/report/page/detail/page_plane.hpp"
#include "graze/report/page/detail/page_tables.hpp"

namespace graze {
namespace {

// The places of the regions as the cells of a plane.
Plane plane_of(const LociRecord& record) {
  const StableRegions& regions = *record.regions;
  const RegionPlace &first = regions.places.front(), &last = regions.places.back();
  Plane plane;
  plane.x = {record.traced.first, first.value, last.value, regions.columns};
  plane.y = {record.traced.second, first.second, last.second, regions.rows};
  return plane;
}

// Kinds are what is stable; their colours those of the tints behind the curves of a picture.
MapLegend region_legend(const StableRegions& regions) {
  const RegionTints tints = region_tints(regions);
  MapLegend legend;
  std::map<int, std::size_t> entries;  // of tints
  std::map<std::string, int> kinds;
  for (std::size_t i = 0; i < regions.places.size(); ++i) {
    const RegionPlace& place = regions.places[i];
    if (!place.finished) {
      legend.kind_of.push_back(-1);
      continue;
    }
    const std::string label = label_of(place.stable);
    const auto [kind, is_new] = kinds.emplace(label, static_cast<int>(legend.kinds.size()));
    if (is_new) {
      const int tint = tints.of[i];
      const auto [entry, is_first] = entries.emplace(tint, legend.entries.size());
      if (is_first)
        legend.entries.push_back(
            tint < 0 ? MapLegend::Entry{"nothing stable found", ground_look("none").colour}
                     : MapLegend::Entry{tints.grounds[static_cast<std::size_t>(tint)].title,
                                        tints.grounds[static_cast<std::size_t>(tint)].colour});
      legend.kinds.push_back({label.empty() ? "nothing stable found" : label, entry->second});
    }
    legend.kind_of.push_back(kind->second);
  }
  return legend;
}

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
  Json view = page_view(record.info, record.outcome, record.warnings, {});
  view["kind"] = "map";
  view["title"] = record.regions ? "Stable motions and loci" : "Loci of special points";
  view["shown"] = "kind";
  view["numbers"] = Json::array();
  view["is_of_starts"] = false;
  view["motions"] = packed(std::vector<std::int32_t>());
  if (record.regions) {
    const StableRegions& regions = *record.regions;
    const Plane plane = plane_of(record);
    view["x"] = plane_axis_json(plane.x, record.unit);
    view["y"] = plane_axis_json(plane.y, record.second_unit);
    const auto message = [&](std::size_t i) -> const std::string& {
      return regions.places[i].message;
    };
    view["cells"] = cells_json({"stable motions", region_legend(regions), message});
    view["command"] = cell_command_json(page_command(record.info, "orbit", {}),
                                        fmt::format(" --period {}", regions.period), plane, scene);
  } else {
    AxisRange x, y;
    x.include(record.from), x.include(record.to);
    y.include(record.second_from), y.include(record.second_to);
    view["x"] = plane_axis_json(record.traced.first, record.unit, x);
    view["y"] = plane_axis_json(record.traced.second, record.second_unit, y);
    view["cells"] = nullptr;
  }
  view["loci"] = loci_json(&record.traced);
  view["tables"] = tables_json({loci_table(record)});
  write_page_file(file, view, Json::array());
}

}  // namespace graze
