#include "graze/report/chart/detail/chart_loci.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "graze/record/detail/study_records.hpp"
#include "graze/record/names/detail/sweep_names.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/chart/detail/chart_looks.hpp"
#include "graze/report/chart/detail/region_tints.hpp"

namespace graze {
namespace {

constexpr double kLociHeight = 7.0;  // cm
constexpr double kHeavy = 1.3;       // of few loci, by a branch's line

void add(const OrbitLocus& locus, const LocusPart& part, ChartSeries& series) {
  for (std::size_t i = part.first; i <= part.last; ++i)
    add_point(series, locus.points[i].value, locus.points[i].second);
  constexpr double kEnd = std::numeric_limits<double>::quiet_NaN();
  add_point(series, kEnd, kEnd);
}

}  // namespace

std::vector<LocusPart> locus_parts(const OrbitLocus& locus) {
  std::vector<LocusPart> parts;
  for (std::size_t i = 0; i + 1 < locus.points.size(); ++i) {
    const bool is_real = locus.points[i].admissible && locus.points[i + 1].admissible;
    if (parts.empty() || parts.back().is_real != is_real) parts.push_back({is_real, i, i});
    parts.back().last = i + 1;
  }
  return parts;
}

void add_loci(const OrbitLoci& traced, ChartPanel& panel) {
  // Lines are thinner when there are many.
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
      panel.names.push_back({ChartName::Of::kPoint, point.id, {{point.at.value, point.at.second}}});
    }
  }
  std::sort(panel.names.begin(), panel.names.end(),
            [](const ChartName& one, const ChartName& other) { return one.text < other.text; });
  std::vector<ChartSeries> all = {std::move(by_kind.at("virtual"))};
  for (const OrbitLocusKind kind : kOrbitLocusKinds) all.push_back(by_kind.at(label_of(kind)));
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
  return {.title = record.regions ? "Stable motions and loci" : "Loci of special points",
          .rows = {{std::move(panel)}}};
}

}  // namespace graze
