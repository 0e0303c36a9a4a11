#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/special_names.hpp"
#include "graze/report/names.hpp"
#include "graze/report/picture_style.hpp"
#include "graze/report/pictures.hpp"
#include "graze/report/special_marks.hpp"

namespace graze {
namespace {

constexpr double kProportion = 0.75;
constexpr int kPixels = 2000;  // across a picture of 12 cm
constexpr std::size_t kColumns = 2;

enum Line : std::size_t { kVirtual, kOpen, kUnstable, kStable, kLines };
struct LineStyle {
  const char *name, *title, *style;
};
// In the order in which they are drawn: what is seen in an experiment lies on top.
constexpr std::array<LineStyle, kLines> kLineStyles = {
    {{"virtual", "virtual", "lw 0.8 dt solid lc rgb '#999999'"},
     {"open", "stability open", "lw 1.2 dt (2,3) lc rgb '#000000'"},
     {"unstable", "unstable", "lw 1.2 dt (8,5) lc rgb '#D55E00'"},
     {"stable", "stable", "lw 1.1 dt solid lc rgb '#0072B2'"}}};

enum Dot : std::size_t { kWild, kPeriodic, kDots };
struct DotStyle {
  const char *name, *title, *colour;
};
constexpr std::array<DotStyle, kDots> kDotStyles = {
    {{"wild", "sweep: not periodic", "#999999"}, {"periodic", "sweep: periodic", "#000000"}}};

Line line_of(const Orbit& orbit) {
  if (!orbit.admissible) return kVirtual;
  if (!orbit.stable) return kOpen;
  return *orbit.stable ? kStable : kUnstable;
}

// A point of a branch; special points belong to both sides and have no line of their own.
struct Node {
  double x = 0.0;
  std::vector<double> y;
  std::optional<Line> line;
};

class DiagramPicture {
 public:
  DiagramPicture(const DiagramRecord& record, bool as_pixels)
      : record_(record), as_pixels_(as_pixels) {
    collect_dots();
    set_units();
    for (std::size_t i = 0; i < record.curves.size(); ++i) add_branch(i);
    for (const auto& [x, y, wild] : dots_)
      dot_tables_[wild ? kWild : kPeriodic].row({x_unit_.factor * x, y_unit_.factor * y});
    size_margins();
  }

  GnuplotScript script() {
    set_style(script_);
    for (std::size_t k = 0; k < kLines; ++k)
      if (!lines_[k].empty()) script_.data(kLineStyles[k].name, lines_[k]);
    for (const auto& [label, table] : marks_) script_.data("special_" + label, table);
    if (!as_pixels_) write_dots(script_);
    set_axes();
    script_.plot(layers());
    return script_;
  }

  // The dots alone, over the whole of a canvas that is the inside of the axes.
  PixelLayer dots() const {
    PixelLayer layer;
    layer.width = static_cast<int>(kPixels * (1.0 - margins_.left - margins_.right));
    layer.height = static_cast<int>(kPixels * kProportion * (1.0 - margins_.top - margins_.bottom));
    set_margins(layer.script, {0.0, 0.0, 0.0, 0.0});
    layer.script.command("unset border\nunset tics\nunset key");
    layer.script.command("set xrange " + x_.text() + "\nset yrange " + y_.text());
    write_dots(layer.script);
    // Points of size 1 are some 5 pixels wide here, so a dot is 0.3 mm at most.
    layer.script.plot(dot_layers(1.0));
    return layer;
  }

 private:
  struct DotAt {
    double x, y;
    bool wild;
  };

  void collect_dots() {
    for (const SweepRow& row : record_.swept.rows) {
      const bool wild = row.status == SweepStatus::kNotPeriodic;
      if (!wild && row.motion.period == 0) continue;
      if (record_.section == DiagramSection::kImpact)
        for (const MetImpact& impact : row.motion.impacts)
          dots_.push_back({row.value, impact.speed, wild});
      else
        for (const SweepRow::Strobe& strobe : row.strobes)
          if (strobe.stop == 0) dots_.push_back({row.value, strobe.displacement, wild});
    }
  }

  // The axes span what the sweep and the admissible parts of the branches reach.
  void set_units() {
    AxisRange y;
    for (const DotAt& dot : dots_) y.include(dot.y);
    for (std::size_t i = 0; i < record_.curves.size(); ++i)
      for (const auto& heights : record_.curves[i].points)
        for (const double height : heights) y.include(height);
    if (record_.section == DiagramSection::kImpact || y.empty()) y.include(0.0);
    const BranchRecord& branches = record_.branches;
    x_unit_ = axis_unit(branches.unit, std::max(std::abs(branches.from), std::abs(branches.to)));
    y_unit_ = axis_unit(record_.section == DiagramSection::kImpact ? "m/s" : "m",
                        std::max(std::abs(y.low), std::abs(y.high)));
    x_.include(x_unit_.factor * branches.from);
    x_.include(x_unit_.factor * branches.to);
    x_.settle(0.0);
    y_ = {y_unit_.factor * y.low, y_unit_.factor * y.high};
    y_.settle(0.05);
  }

  Node node(const OrbitBranchPoint& point, const std::vector<double>& heights) const {
    Node node{x_unit_.factor * point.value, heights, line_of(point.orbit)};
    for (double& y : node.y) y *= y_unit_.factor;
    return node;
  }

  void add_branch(std::size_t i) {
    const OrbitBranch& branch = record_.branches.traced.branches[i];
    const DiagramCurve& curve = record_.curves[i];
    std::vector<Node> nodes;
    for (std::size_t k = 0; k < branch.points.size(); ++k) {
      nodes.push_back(node(branch.points[k], curve.points[k]));
      if (k > 0) align(nodes[k - 1], nodes[k]);
    }
    // Where it joins orbits of half the period a multiplier is 1; that says nothing of the branch.
    if (branch.ends[0] == OrbitBranchEnd::kPeriodDoubling) nodes.front().line.reset();
    if (branch.ends[1] == OrbitBranchEnd::kPeriodDoubling) nodes.back().line.reset();
    for (std::size_t k = 0; k < branch.special.size(); ++k) {
      Node special = node(branch.special[k].at, curve.special[k]);
      special.line.reset();
      insert(nodes, special);
      for (const double y : special.y) marks_[label_of(branch.special[k].kind)].row({special.x, y});
    }
    for (std::size_t j = 0; !nodes.empty() && j < nodes.front().y.size(); ++j) draw(nodes, j);
  }

  // The impacts of an orbit are listed by their phases, and the first may become the last from one
  // point to the next: turned so that each stays near itself.
  void align(const Node& before, Node& node) const {
    if (node.y.size() != before.y.size() || node.y.size() < 2) return;
    std::vector<double> best = node.y;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t turn = 0; turn < node.y.size(); ++turn) {
      double distance = 0.0;
      for (std::size_t j = 0; j < node.y.size(); ++j) distance += std::abs(node.y[j] - before.y[j]);
      if (distance < least) {
        least = distance;
        best = node.y;
      }
      std::rotate(node.y.begin(), node.y.begin() + 1, node.y.end());
    }
    node.y = best;
  }

  // Between the two nodes that it makes the smallest detour from.
  void insert(std::vector<Node>& nodes, Node& special) const {
    const auto distance = [&](const Node& a, const Node& b) {
      return std::hypot((a.x - b.x) / x_.span(), (a.y.front() - b.y.front()) / y_.span());
    };
    double least = std::numeric_limits<double>::infinity();
    std::size_t place = nodes.size();
    for (Node& node : nodes) {
      align(node, special);
      if (node.y.size() != special.y.size() || node.y.empty()) return;
      if (distance(node, special) > 0.0) continue;
      node.line.reset();
      return;
    }
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      align(nodes[i], special);
      const double detour = distance(nodes[i], special) + distance(special, nodes[i + 1]) -
                            distance(nodes[i], nodes[i + 1]);
      if (detour >= least) continue;
      least = detour;
      place = i + 1;
    }
    // Not a part of this curve unless it nearly lies on it.
    if (!(least < 0.05)) return;
    align(nodes[place - 1], special);
    nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(place), special);
  }

  // Between two nodes the curve is what its first node is; where that has no line, the second.
  void draw(const std::vector<Node>& nodes, std::size_t j) {
    std::optional<Line> current;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      const std::optional<Line> line = nodes[i].line ? nodes[i].line : nodes[i + 1].line;
      if (!line || nodes[i].y.size() <= j || nodes[i + 1].y.size() <= j) continue;
      if (line != current) {
        lines_[*line].gap();
        lines_[*line].row({nodes[i].x, nodes[i].y[j]});
        current = line;
      }
      lines_[*line].row({nodes[i + 1].x, nodes[i + 1].y[j]});
    }
  }

  bool has_hertz() const { return record_.branches.traced.parameter == "forcing.frequency"; }

  void size_margins() {
    margins_.bottom += legend_height(legend().size(), kColumns);
    if (has_hertz()) margins_.top = 0.145;
  }

  void set_axes() {
    set_margins(script_, margins_);
    set_legend(script_, margins_, kColumns);
    script_.command("set xrange " + x_.text());
    script_.command(fmt::format("set xtics {:.6g}", x_.tic_step(7)));
    script_.command("set yrange " + y_.text());
    script_.command(fmt::format("set ytics {:.6g}", y_.tic_step(8)));
    script_.command("set xlabel " +
                    axis_label(parameter_title(record_.branches.traced.parameter), x_unit_.unit));
    name_vertical_axis(
        script_,
        record_.section == DiagramSection::kImpact ? "impact speed" : "displacement at the stop",
        y_unit_.unit);
    if (has_hertz()) {
      const AxisRange hertz{x_.low / kTurn, x_.high / kTurn};
      script_.command("set border 7\nset x2range " + hertz.text());
      script_.command(fmt::format("set x2tics {:.6g}", hertz.tic_step(9)));
      script_.command("set x2label 'forcing frequency (Hz)'");
    }
    if (dots_.empty() && marks_.empty() && record_.curves.empty())
      script_.command("set label 'no impacts' at graph 0.5, graph 0.5 center");
  }

  // Motions that never repeat fill areas: their dots shrink as they crowd.
  double dot_size(std::size_t kind) const {
    if (kind != kWild) return 1.0;
    const auto crowd =
        std::count_if(dots_.begin(), dots_.end(), [](auto& dot) { return dot.wild; });
    return std::clamp(std::sqrt(4000.0 / static_cast<double>(crowd)), 0.5, 1.0);
  }

  void write_dots(GnuplotScript& script) const {
    for (std::size_t k = 0; k < kDots; ++k)
      if (!dot_tables_[k].empty()) script.data(kDotStyles[k].name, dot_tables_[k]);
  }

  std::vector<std::string> dot_layers(double size) const {
    std::vector<std::string> layers;
    for (std::size_t k = 0; k < kDots; ++k)
      if (!dot_tables_[k].empty())
        layers.push_back(fmt::format("${} with points pt 7 ps {:.3g} lc rgb '{}'",
                                     kDotStyles[k].name, size * dot_size(k), kDotStyles[k].colour));
    return layers;
  }

  std::vector<std::string> layers() const {
    std::vector<std::string> layers;
    if (as_pixels_ && !dots_.empty()) {
      const PixelLayer layer = dots();
      const double dx = x_.span() / layer.width, dy = y_.span() / layer.height;
      layers.push_back(
          fmt::format("pixels binary filetype=png origin=({:.12g},{:.12g}) "
                      "dx={:.12g} dy={:.12g} with rgbalpha",
                      x_.low + dx / 2.0, y_.low + dy / 2.0, dx, dy));
    } else {
      layers = dot_layers(0.16);
    }
    for (std::size_t k = 0; k < kLines; ++k)
      if (!lines_[k].empty())
        layers.push_back(
            fmt::format("${} with lines {}", kLineStyles[k].name, kLineStyles[k].style));
    for (const auto& [label, table] : marks_) {
      const SpecialMark mark = special_mark(label);
      // Filled with the paper's white, so that the curve does not run through the outline.
      if (mark.ground > 0)
        layers.push_back(fmt::format("$special_{} with points pt {} ps {:.2f} lc rgb '#FFFFFF'",
                                     label, mark.ground, mark_size() * mark.size));
      layers.push_back(fmt::format("$special_{} {}", label, mark_style(mark)));
    }
    for (const std::string& entry : legend()) layers.push_back(entry);
    return layers;
  }

  std::string mark_style(const SpecialMark& mark) const {
    return fmt::format("with points pt {} ps {:.2f} lw 1.2 lc rgb '{}'", mark.point,
                       mark_size() * mark.size, mark.colour);
  }

  double mark_size() const {
    std::size_t count = 0;
    for (const DiagramCurve& curve : record_.curves)
      for (const std::vector<double>& heights : curve.special) count += heights.size();
    return crowded_mark_size(count);
  }

  std::vector<std::string> legend() const {
    std::vector<std::string> entries;
    for (std::size_t k = kDots; k-- > 0;)
      if (!dot_tables_[k].empty())
        entries.push_back(fmt::format("NaN with points pt 7 ps 0.35 lc rgb '{}' title '{}'",
                                      kDotStyles[k].colour, kDotStyles[k].title));
    for (std::size_t k = kLines; k-- > 0;)
      if (!lines_[k].empty())
        entries.push_back(fmt::format("NaN with lines {} title '{}'", kLineStyles[k].style,
                                      kLineStyles[k].title));
    for (const auto& [label, table] : marks_)
      entries.push_back(fmt::format("NaN {} title {}", mark_style(special_mark(label)),
                                    gnuplot_string(special_mark(label).title)));
    return entries;
  }

  const DiagramRecord& record_;
  bool as_pixels_;
  std::vector<DotAt> dots_;
  AxisUnit x_unit_, y_unit_;
  AxisRange x_, y_;
  Margins margins_;
  std::array<PlotTable, kDots> dot_tables_;
  std::array<PlotTable, kLines> lines_;
  std::map<std::string, PlotTable> marks_;  // by label
  GnuplotScript script_;
};

}  // namespace

void draw_diagram(const std::string& file, const DiagramRecord& record) {
  const bool as_pixels = !file.ends_with(".png");
  DiagramPicture picture(record, as_pixels);
  if (!as_pixels) return draw_picture(file, picture.script(), kProportion);
  draw_picture(file, picture.script(), kProportion, picture.dots());
}

}  // namespace graze
