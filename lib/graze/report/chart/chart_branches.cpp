#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "graze/bifurcation/problem/detail/special_names.hpp"
#include "graze/record/names/detail/sweep_names.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/chart/detail/branch_lines.hpp"
#include "graze/report/chart/detail/chart_looks.hpp"
#include "graze/report/chart/detail/motion_observables.hpp"

namespace graze {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kOnlyPanel = 6.6, kOneOfSeveral = 4.3;  // heights, cm
constexpr std::size_t kMostPanelPlaces = 4;
constexpr double kThin = 0.55;  // of curves over dots, by those without
constexpr double kCut = 2.0;    // of marks where an axis cuts, by dots
constexpr double kLone = 0.5;   // of a branch that is one point

// Dots of a panel by the ids of their looks, and the heights on its axis.
struct PanelDots {
  std::map<std::string, ChartSeries> series;
  AxisRange range;
  double least = -1e300, most = 1e300;

  void include(double height) { range.include(std::clamp(height, least, most)); }
  void add(const char* look, double value, double height) {
    add_point(series.try_emplace(look, dots_of(dot_look(look))).first->second, value, height);
    include(height);
  }
};

// Dots that lie on top come last. Motions that never repeat fill areas: their dots shrink with
// their number.
void add_dots(PanelDots& dots, ChartPanel& panel) {
  for (const char* id : {"cut", "lower", "wild", "largest", "periodic"}) {
    const auto found = dots.series.find(id);
    if (found == dots.series.end()) continue;
    ChartSeries& series = found->second;
    if (id == std::string("wild")) series.look.size *= crowded_dot_size(series.x.size(), 0.5);
    if (id == std::string("cut")) series.look.size *= kCut;
    panel.series.push_back(std::move(series));
  }
}

class BranchesChart {
 public:
  BranchesChart(const BranchRecord& record, const Sweep* swept) : record_(record), swept_(swept) {
    for (const double end : {record.from, record.to}) across_.include(end);
  }

  void add(const MotionObservable& observable, bool is_asked) {
    PanelDots dots;
    dots.most = observable.most;
    if (swept_ && observable.heights)
      for (const SweepRow& row : swept_->rows)
        if (has_dots(row))
          for (const double height : observable.heights(row))
            dots.add(row.status == SweepStatus::kNotPeriodic ? "wild" : "periodic", row.value,
                     height);
    for (const DiagramCurve& curve : observable.curves)
      for (const std::vector<double>& point : curve.points)
        for (const double height : point) dots.include(height);
    ChartPanel& panel = begin({.name = observable.name,
                               .unit = observable.unit,
                               .from_zero = observable.from_zero,
                               .is_asked = is_asked},
                              observable.reference, dots);
    if (!observable.curves.empty()) add_branches(observable.curves, panel);
    if (panel.series.empty()) panel.remark = swept_ ? "no impacts" : "no branch was found";
  }

  void add_exponents() {
    PanelDots dots;
    dots.least = exponent_range(*swept_).low;
    for (const SweepRow& row : swept_->rows)
      for (Eigen::Index j = 0; row.exponents && j < row.exponents->values.size(); ++j) {
        const double height = row.exponents->values[j];
        if (height < dots.least)  // minus infinity too
          dots.add("cut", row.value, dots.least);
        else if (std::isfinite(height))
          dots.add(j > 0 ? "lower" : "largest", row.value, height);
      }
    begin({.name = "Lyapunov exponents",
           .unit = unit_in(record_.info.units, "1/s"),
           .from_zero = true},
          0.0, dots);
  }

  Chart take() {
    for (std::vector<ChartPanel>& row : chart_.rows)
      row[0].height = chart_.rows.size() == 1 ? kOnlyPanel : kOneOfSeveral;
    // The look that lies on top comes first.
    for (const Look& look : dot_looks()) chart_.legend.push_back(look.title);
    for (std::size_t kind = kLineKinds; kind-- > 0;)
      chart_.legend.push_back(line_looks()[kind].title);
    for (const std::string& title : marks_) chart_.legend.push_back(title);
    chart_.legend.push_back(virtual_special_look().title);
    return std::move(chart_);
  }

 private:
  ChartPanel& begin(ChartAxis up, std::optional<double> level, PanelDots& dots) {
    constexpr double kMargin = 0.05;
    AxisRange range = dots.range;
    if (up.from_zero || range.empty()) range.include(0.0);
    if (level) range.include(*level);
    range.settle(kMargin);
    up.range = range;
    const std::string& path = record_.traced.parameter;
    ChartPanel panel{
        .x = {.name = parameter_title(path), .unit = record_.unit, .range = across_, .path = path},
        .y = std::move(up)};
    if (level) panel.levels.push_back(*level);
    add_dots(dots, panel);
    chart_.rows.push_back({std::move(panel)});
    return chart_.rows.back().front();
  }

  void add_branches(const std::vector<DiagramCurve>& curves, ChartPanel& panel) {
    const BranchLines made =
        branch_lines(record_.traced.branches, curves, across_.span(), panel.y.range.span());
    for (std::size_t kind = 0; kind < kLineKinds; ++kind) {
      Look look = line_looks()[kind];
      if (swept_) look.width *= kThin;
      ChartSeries lines{.title = look.title, .look = look, .x = {}, .y = {}};
      look.id = "lone_" + look.id;
      look.mark = MarkShape::kDot;
      look.size = kLone;
      ChartSeries points = marks_of(look);
      for (const BranchLine& line : made.lines)
        if (line.kind == kind) add(line, line.is_dot() ? points : lines);
      for (ChartSeries* series : {&lines, &points})
        if (!series->x.empty()) panel.series.push_back(std::move(*series));
    }
    add_marks(made.marks, panel);
    if (panel.y.is_asked) name(made, panel);
  }

  static void add(const BranchLine& line, ChartSeries& series) {
    if (series.is_line && !series.x.empty()) add_point(series, kNone, kNone);
    for (const BranchLine::Node& node : line.nodes) add_point(series, node.x, node.y);
  }

  const SpecialPoint& special_of(const BranchMark& mark) const {
    return record_.traced.branches[mark.branch].special[mark.special];
  }

  // The label is the title of a kind without a look.
  void add_marks(const std::vector<BranchMark>& marks, ChartPanel& panel) {
    const double size = crowded_mark_size(marks.size());
    ChartSeries others = marks_of(virtual_special_look());
    std::map<SpecialKind, ChartSeries> by_kind;
    for (const BranchMark& mark : marks) {
      const SpecialPoint& special = special_of(mark);
      const bool is_real = special.at.orbit.admissible;
      Look look = special_look(label_of(special.kind));
      if (look.id.empty()) look.id = look.title = label_of(special.kind);
      ChartSeries& series =
          is_real ? by_kind.try_emplace(special.kind, marks_of(look)).first->second : others;
      for (const double y : mark.y) add_point(series, mark.x, y);
    }
    std::vector<ChartSeries> all = {std::move(others)};
    for (auto& [kind, series] : by_kind) all.push_back(std::move(series));
    for (ChartSeries& series : all) {
      if (series.x.empty()) continue;
      series.look.size *= size;
      if (&series != all.data() &&
          std::find(marks_.begin(), marks_.end(), series.title) == marks_.end())
        marks_.push_back(series.title);
      panel.series.push_back(std::move(series));
    }
  }

  // Adds the ids of special points, and the names of branches, each once, on its line of the best
  // kind; not with many ids, among which those of the orbits would be lost.
  void name(const BranchLines& made, ChartPanel& panel) const {
    constexpr std::size_t kDozen = 12, kPlaces = 24;
    for (const BranchMark& mark : made.marks)
      if (!mark.y.empty() && special_of(mark).at.orbit.admissible)
        panel.names.push_back(
            {ChartName::Of::kPoint, special_of(mark).id, {{mark.x, mark.y.front()}}});
    if (panel.names.size() > kDozen) return;
    for (std::size_t b = 0; b < record_.traced.branches.size(); ++b) {
      const OrbitBranch& branch = record_.traced.branches[b];
      std::size_t best = 0;
      for (const BranchLine& line : made.lines)
        if (line.branch == b) best = std::max<std::size_t>(best, line.kind);
      std::vector<std::pair<double, double>> nodes, places;
      for (const BranchLine& line : made.lines)
        if (line.branch == b && line.kind == best)
          for (const BranchLine::Node& node : line.nodes) nodes.emplace_back(node.x, node.y);
      const std::size_t stride = nodes.size() / kPlaces + 1;
      for (std::size_t i = stride / 2; i < nodes.size(); i += stride) places.push_back(nodes[i]);
      panel.names.push_back(
          {ChartName::Of::kCurve,
           orbit_label(branch.pattern.period, branch.pattern.impacts(), branch.sticks()),
           std::move(places)});
    }
  }

  const BranchRecord& record_;
  const Sweep* swept_;  // or null
  AxisRange across_;
  std::vector<std::string> marks_;  // titles that there are
  Chart chart_;
};

// Shows the first of several observables of a motion, and displacements in all cases.
Chart branches_chart(const BranchRecord& record, const Sweep* swept,
                     const std::vector<MotionObservable>& observables, bool multipliers) {
  BranchesChart chart(record, swept);
  std::size_t panels = 0;
  for (const MotionObservable& observable : observables) {
    const bool is_main =
        &observable == observables.data() ||
        (!record.shown && observable.key.starts_with("displacement_") && panels < kMostPanelPlaces);
    if (!is_main && !(multipliers && observable.key == "multiplier")) continue;
    chart.add(observable, is_main);
    ++panels;
  }
  if (swept && swept->options.exponent_periods > 0) chart.add_exponents();
  return chart.take();
}

}  // namespace

Chart chart_of(const BranchRecord& record, bool multipliers) {
  return branches_chart(record, nullptr, motion_observables(record, nullptr), multipliers);
}

Chart chart_of(const DiagramRecord& record, bool multipliers) {
  return branches_chart(record.branches, &record.swept, motion_observables(record), multipliers);
}

}  // namespace graze
