#include "branches_chart.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

#include "graze/bifurcation/problem/detail/special_names.hpp"
#include "graze/report/picture/detail/branch_lines.hpp"
#include "graze/report/picture/detail/diagram_panels.hpp"

namespace graze {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kMargin = 0.05;   // beyond what is drawn, as a part of it
constexpr double kOnePanel = 7.0;  // cm; several have the height that charts give them

ChartSeries series_of(const Look& look, bool is_line) {
  return {.title = look.title,
          .look = look,
          .is_line = is_line,
          .has_marks = !is_line,
          .x = {},
          .y = {}};
}

// Those that lie on top come last.
void add_dots(const DiagramPanel& panel, ChartPanel& drawn) {
  for (const char* id : {"cut", "lower", "wild", "largest", "periodic"}) {
    ChartSeries series = series_of(dot_look(id), false);
    for (const DiagramPanel::Dot& dot : panel.dots) {
      if (dot.look->id != id) continue;
      series.x.push_back(dot.value);
      series.y.push_back(dot.height);
    }
    if (!series.x.empty()) drawn.series.push_back(std::move(series));
  }
}

void add_marks(const std::vector<OrbitBranch>& branches, const std::vector<BranchMark>& marks,
               ChartPanel& drawn) {
  std::map<std::string, ChartSeries> by_title;
  for (const BranchMark& mark : marks) {
    const SpecialPoint& special = branches[mark.branch].special[mark.special];
    const std::string label = label_of(special.kind);
    Look look = special.at.orbit.admissible ? special_look(label) : virtual_special_look();
    if (look.title.empty()) look.title = label;
    ChartSeries& series = by_title.try_emplace(look.title, series_of(look, false)).first->second;
    for (const double y : mark.y) {
      series.x.push_back(mark.x);
      series.y.push_back(y);
    }
  }
  for (auto& [title, series] : by_title)
    if (!series.x.empty()) drawn.series.push_back(std::move(series));
}

void add_branches(const std::vector<OrbitBranch>& branches, const DiagramPanel& panel,
                  const PicturePlane& plane, ChartPanel& drawn) {
  if (panel.curves.empty()) return;
  const BranchLines made = branch_lines(branches, panel.curves, plane);
  std::array<ChartSeries, kLineKinds> lines;
  for (std::size_t kind = 0; kind < kLineKinds; ++kind)
    lines[kind] = series_of(line_looks()[kind], true);
  for (const BranchLine& line : made.lines) {
    ChartSeries& series = lines[line.kind];
    // A branch that is a point is a dot, and has a mark for it.
    if (line.is_dot()) series.look.mark = MarkShape::kDot, series.has_marks = true;
    if (!series.x.empty()) series.x.push_back(kNone), series.y.push_back(kNone);
    for (const BranchLine::Node& node : line.nodes) {
      series.x.push_back(node.x);
      series.y.push_back(node.y);
    }
  }
  for (ChartSeries& series : lines)
    if (!series.x.empty()) drawn.series.push_back(std::move(series));
  add_marks(branches, made.marks, drawn);
}

AxisRange heights_of(const DiagramPanel& panel) {
  AxisRange range;
  const auto include = [&](double height) {
    range.include(std::clamp(height, panel.least, panel.most));
  };
  for (const DiagramPanel::Dot& dot : panel.dots) include(dot.height);
  for (const DiagramCurve& curve : panel.curves)
    for (const std::vector<double>& point : curve.points)
      for (const double height : point) include(height);
  if (panel.from_zero) range.include(0.0);
  if (panel.level) range.include(*panel.level);
  range.settle(kMargin);
  if (panel.from_zero && range.low < 0.0 && range.low > -kMargin * range.high) range.low = 0.0;
  return range;
}

}  // namespace

Chart branches_chart(const BranchRecord& record, const DiagramRecord* diagram) {
  Chart chart;
  AxisRange across;
  for (const double end : {record.from, record.to}) across.include(end);
  const std::vector<DiagramPanel> panels = diagram_panels(record, diagram, false);
  for (const DiagramPanel& panel : panels) {
    ChartPanel drawn;
    const std::string& path = record.traced.parameter;
    drawn.x = {.name = parameter_title(path), .unit = record.unit, .range = across, .path = path};
    drawn.y = {.name = panel.name, .unit = panel.unit, .range = heights_of(panel)};
    if (panels.size() == 1) drawn.height = kOnePanel;
    add_dots(panel, drawn);
    add_branches(record.traced.branches, panel, {1.0, 1.0, across, drawn.y.range}, drawn);
    if (panel.level) drawn.levels.push_back(*panel.level);
    if (drawn.series.empty()) drawn.remark = diagram ? "no impacts" : "no branch was found";
    chart.rows.push_back({std::move(drawn)});
  }
  return chart;
}

}  // namespace graze
