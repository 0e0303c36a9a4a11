#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "graze/bifurcation/problem/detail/special_names.hpp"
#include "graze/record/names/motion_names.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/chart/detail/branch_lines.hpp"
#include "graze/report/chart/detail/chart_looks.hpp"
#include "graze/report/chart/detail/motion_observables.hpp"
#include "graze/report/chart/detail/motion_things.hpp"

namespace graze {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kOnlyPanel = 6.6, kOneOfSeveral = 4.3;  // heights, cm
constexpr std::size_t kMostPanelPlaces = 4;
constexpr double kStrip = 2.6;  // below what is looked into
constexpr double kThin = 0.55;  // of curves over dots, by those without
constexpr double kCut = 2.0;    // of marks where an axis cuts, by dots
constexpr double kLone = 0.5;   // of a branch that is one point

// Dots of a panel by the ids of their looks, and the heights on its axis.
struct PanelDots {
  std::map<std::string, ChartSeries> series;
  AxisRange range;
  double least = -1e300, most = 1e300;

  void include(double height) { range.include(std::clamp(height, least, most)); }
  // `row`: of the sweep; `which`: of the dots that it has.
  void add(const char* look, double value, double height, std::size_t row, std::size_t which = 0) {
    ChartSeries& dots = series.try_emplace(look, dots_of(dot_look(look))).first->second;
    add_point(dots, value, height);
    dots.of.push_back(static_cast<int>(row));
    dots.which.push_back(static_cast<int>(which));
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
  // `explored`: for a page, where numbers stand over each other.
  BranchesChart(const BranchRecord& record, const Sweep* swept, bool explored)
      : record_(record),
        swept_(swept),
        explored_(explored),
        numbers_(record.traced.branches, swept ? swept->rows.size() : 0) {
    for (const double end : {record.from, record.to}) across_.include(end);
  }

  void add(const MotionObservable& observable, bool is_asked) {
    PanelDots dots;
    dots.most = observable.most;
    for (std::size_t i = 0; swept_ && i < swept_->rows.size(); ++i)
      if (has_dots(swept_->rows[i])) add_row(i, observable, dots);
    for (const DiagramCurve& curve : observable.curves)
      for (const std::vector<double>& point : curve.points)
        for (const double height : point) dots.include(height);
    ChartPanel& panel = begin({.name = observable.name,
                               .unit = observable.unit,
                               .from_zero = observable.from_zero,
                               .is_asked = is_asked,
                               .key = observable.key},
                              observable.reference, dots);
    if (!observable.curves.empty()) add_branches(observable.curves, panel);
    if (panel.series.empty()) panel.remark = swept_ ? "no impacts" : "no branch was found";
  }

  void add_exponents() {
    PanelDots dots;
    dots.least = exponent_range(*swept_).low;
    for (std::size_t i = 0; i < swept_->rows.size(); ++i) {
      const SweepRow& row = swept_->rows[i];
      for (Eigen::Index j = 0; row.exponents && j < row.exponents->values.size(); ++j) {
        const double height = row.exponents->values[j];
        if (height < dots.least)  // minus infinity too
          dots.add("cut", row.value, dots.least, i);
        else if (std::isfinite(height))
          dots.add(j > 0 ? "lower" : "largest", row.value, height, i);
      }
    }
    begin({.name = "Lyapunov exponents",
           .unit = unit_in(record_.info.units, "1/s"),
           .from_zero = true},
          0.0, dots);
  }

  // All that follows but exponents is no panel of its own.
  void begin_layouts(ChartThings things) {
    chart_.things = std::move(things);
    chart_.title = swept_ ? "Bifurcation diagram" : "Branches of orbits";
    first_ = std::move(chart_.rows);
    chart_.rows.clear();
  }
  void end_layouts() {
    for (std::vector<ChartPanel>& row : chart_.rows) chart_.layouts.push_back(std::move(row[0]));
    chart_.rows = std::move(first_);
  }

  Chart take() {
    for (std::vector<ChartPanel>& row : chart_.rows)
      row[0].height = chart_.rows.size() == 1 ? kOnlyPanel : kOneOfSeveral;
    if (explored_ && chart_.rows.size() > 1) {
      chart_.rows.front()[0].height = kOnlyPanel;
      chart_.rows.back()[0].height = kStrip;
    }
    // What lies on top comes first.
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
    ChartPanel panel{.x = {.name = parameter_title(path),
                           .unit = record_.unit,
                           .range = across_,
                           .path = path,
                           .key = path},
                     .y = std::move(up)};
    if (level) panel.levels.push_back(*level);
    add_dots(dots, panel);
    chart_.rows.push_back({std::move(panel)});
    return chart_.rows.back().front();
  }

  // Of what a motion has one of a page needs all rows: they stand for other such numbers too.
  void add_row(std::size_t index, const MotionObservable& observable, PanelDots& dots) const {
    const SweepRow& row = swept_->rows[index];
    std::vector<double> heights;
    if (observable.heights) heights = observable.heights(row);
    if (explored_ && observable.is_of_motion && heights.empty()) heights = {kNone};
    for (std::size_t k = 0; k < heights.size(); ++k)
      dots.add(row.status == SweepStatus::kNotPeriodic ? "wild" : "periodic", row.value, heights[k],
               index, k);
  }

  void add_branches(const std::vector<DiagramCurve>& curves, ChartPanel& panel) {
    const BranchLines made =
        branch_lines(record_.traced.branches, curves, across_.span(), panel.y.range.span());
    for (std::size_t kind = 0; kind < kLineKinds; ++kind) {
      Look look = line_looks()[kind];
      if (swept_ && !explored_) look.width *= kThin;
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

  static void add(double x, double y, int of, int which, ChartSeries& series) {
    add_point(series, x, y);
    series.of.push_back(of);
    series.which.push_back(which);
  }
  void add(const BranchLine& line, ChartSeries& series) const {
    if (series.is_line && !series.x.empty()) add(kNone, kNone, -1, 0, series);
    for (const BranchLine::Node& node : line.nodes)
      add(node.x, node.y, numbers_.of(line.branch, node.point), node.which, series);
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
      for (std::size_t k = 0; k < mark.y.size(); ++k)
        add(mark.x, mark.y[k], numbers_.of(mark.branch, -1 - static_cast<int>(mark.special)),
            mark.which[k], series);
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
  bool explored_;
  MotionNumbers numbers_;
  AxisRange across_;
  std::vector<std::string> marks_;  // titles that there are
  Chart chart_;
  std::vector<std::vector<ChartPanel>> first_;  // while layouts are made
};

// Shows the first of several observables of a motion, and displacements in all cases.
Chart branches_chart(const BranchRecord& record, const Sweep* swept,
                     const std::vector<MotionObservable>& observables, bool multipliers) {
  BranchesChart chart(record, swept, false);
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

// The first observable, and layouts of every other that a motion has several of; one that stands
// for all that it has one of, which if possible has curves.
Chart explored_branches(const BranchRecord& record, const Sweep* swept,
                        const std::vector<MotionObservable>& observables) {
  BranchesChart chart(record, swept, true);
  const MotionObservable& main = observables.front();
  chart.add(main, true);
  chart.begin_layouts(motion_things(record, swept, observables));
  const MotionObservable* single = nullptr;
  for (const MotionObservable& observable : observables) {
    if (&observable == &main) continue;
    if (!observable.is_of_motion) chart.add(observable, true);
    if (observable.is_of_motion &&
        (!single || (single->curves.empty() && !observable.curves.empty())))
      single = &observable;
  }
  if (single && !main.is_of_motion) chart.add(*single, true);
  chart.end_layouts();
  if (swept && swept->options.exponent_periods > 0) chart.add_exponents();
  return chart.take();
}

}  // namespace

Chart explored_chart(const BranchRecord& record) {
  return explored_branches(record, nullptr, motion_observables(record, nullptr));
}

Chart explored_chart(const DiagramRecord& record) {
  return explored_branches(record.branches, &record.swept, motion_observables(record));
}

Chart chart_of(const BranchRecord& record, bool multipliers) {
  return branches_chart(record, nullptr, motion_observables(record, nullptr), multipliers);
}

Chart chart_of(const DiagramRecord& record, bool multipliers) {
  return branches_chart(record.branches, &record.swept, motion_observables(record), multipliers);
}

}  // namespace graze
