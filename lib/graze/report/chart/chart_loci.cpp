#include "graze/report/chart/detail/chart_loci.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "graze/record/names/motion_names.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/chart/detail/chart_looks.hpp"
#include "graze/report/chart/detail/map_legend.hpp"
#include "graze/report/chart/detail/region_tints.hpp"

namespace graze {
namespace {

constexpr double kLociHeight = 7.0;  // cm
constexpr double kHeavy = 1.3;       // of few loci, by a branch's line

// Points of a locus from `first` to `last` whose orbits all are, or are not, some of the system.
// Where the classification changes both parts have the point.
struct LocusPart {
  bool is_real = true;
  std::size_t first = 0, last = 0;
};

std::vector<LocusPart> locus_parts(const OrbitLocus& locus) {
  std::vector<LocusPart> parts;
  for (std::size_t i = 0; i + 1 < locus.points.size(); ++i) {
    const bool is_real = locus.points[i].admissible && locus.points[i + 1].admissible;
    if (parts.empty() || parts.back().is_real != is_real) parts.push_back({is_real, i, i});
    parts.back().last = i + 1;
  }
  return parts;
}

void add(const OrbitLocus& locus, const LocusPart& part, ChartSeries& series) {
  for (std::size_t i = part.first; i <= part.last; ++i)
    add_point(series, locus.points[i].value, locus.points[i].second);
  constexpr double kEnd = std::numeric_limits<double>::quiet_NaN();
  add_point(series, kEnd, kEnd);
}

// "fold and period doubling" of "LPPD".
std::string words_of(const std::string& label) {
  static const std::map<std::string, std::string> kWords = {{"CP", "cusp"},
                                                            {"R1", "1:1 resonance"},
                                                            {"R2", "1:2 resonance"},
                                                            {"R3", "1:3 resonance"},
                                                            {"R4", "1:4 resonance"}};
  if (const auto known = kWords.find(label); known != kWords.end()) return known->second;
  std::string words;
  for (std::size_t i = 0; i + 1 < label.size(); i += 2) {
    const std::string part = label.substr(i, 2);
    const std::string title = special_look(part).title;
    const std::string word =
        title.empty() ? part : title.substr(0, std::min(title.find(" ("), title.size()));
    words += (i > 0 ? " and " : "") + word;
  }
  return words;
}

const char* title_of(const LociRecord& record) {
  return record.regions ? "Stable motions and loci" : "Loci of special points";
}

// The places of the regions as the cells of a plane.
Plane plane_of(const LociRecord& record) {
  const StableRegions& regions = *record.regions;
  const RegionPlace &first = regions.places.front(), &last = regions.places.back();
  Plane plane;
  plane.x = {record.traced.first, first.value, last.value, regions.columns};
  plane.y = {record.traced.second, first.second, last.second, regions.rows};
  return plane;
}

}  // namespace

std::string special_title(const OrbitLocus& locus, const OrbitLocusSpecial& special) {
  return fmt::format("{}: {}, on locus {} ({})", special.id, words_of(special.label), locus.id,
                     label_of(locus.kind));
}

void add_loci(const OrbitLoci& traced, ChartPanel& panel, ChartThings* things) {
  // Thinner as they crowd.
  const double weight = kHeavy * crowded_mark_size(traced.loci.size());
  std::map<std::string, ChartSeries> by_kind;
  for (const Look& look : locus_looks()) {
    ChartSeries series{.title = look.title, .look = look, .x = {}, .y = {}};
    series.look.width *= weight;
    by_kind.emplace(look.id, std::move(series));
  }
  ChartSeries special = marks_of(codimension_two_look());
  for (const OrbitLocus& locus : traced.loci) {
    for (const LocusPart& part : locus_parts(locus))
      add(locus, part, by_kind.at(part.is_real ? label_of(locus.kind) : "virtual"));
    for (const OrbitLocusSpecial& point : locus.special) {
      add_point(special, point.at.value, point.at.second);
      if (things) {
        special.of.push_back(static_cast<int>(things->kind.size()));
        things->kind.push_back(static_cast<int>(things->kinds.size()));
        things->kinds.push_back({special_title(locus, point), point.id, point.id});
      }
      panel.names.push_back({ChartName::Of::kPoint, point.id, {{point.at.value, point.at.second}}});
    }
  }
  std::sort(panel.names.begin(), panel.names.end(),
            [](const ChartName& one, const ChartName& other) { return one.text < other.text; });
  std::vector<ChartSeries> all = {std::move(by_kind.at("virtual"))};
  for (const OrbitLocusKind kind : kOrbitLocusKinds) all.push_back(by_kind.at(label_of(kind)));
  for (const OrbitLocusKind kind : {OrbitLocusKind::kLevel, OrbitLocusKind::kExtreme})
    all.push_back(by_kind.at(label_of(kind)));
  special.look.size *= crowded_mark_size(special.x.size() / 4);
  all.push_back(std::move(special));
  for (ChartSeries& series : all)
    if (!series.x.empty()) panel.series.push_back(std::move(series));
}

Chart chart_of(const LociRecord& record) {
  ChartPanel panel;
  const auto axis = [](const std::string& path, const std::string& unit, double from, double to) {
    ChartAxis made{.name = parameter_title(path), .unit = unit, .path = path};
    for (const double end : {from, to}) made.range.include(end);
    return made;
  };
  panel.x = axis(record.traced.first, record.unit, record.from, record.to);
  panel.y = axis(record.traced.second, record.second_unit, record.second_from, record.second_to);
  panel.height = kLociHeight;
  if (record.regions) add_tints(*record.regions, panel);
  if (!record.regions && record.traced.loci.empty()) panel.remark = "no locus was found";
  add_loci(record.traced, panel);
  return {.title = title_of(record), .rows = {{std::move(panel)}}};
}

Chart explored_chart(const LociRecord& record) {
  ChartPanel panel;
  ChartThings things;
  if (record.regions) {
    panel = cells_panel(plane_of(record), record.unit, record.second_unit);
    things = explored_cells(region_legend(*record.regions), "stable motions", {}, "", *panel.cells);
  } else {
    panel = std::move(chart_of(record).rows[0][0]);
    panel.series.clear();
    panel.names.clear();
  }
  add_loci(record.traced, panel, &things);
  return {.title = title_of(record), .rows = {{std::move(panel)}}, .things = std::move(things)};
}

}  // namespace graze
