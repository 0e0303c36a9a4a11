#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/special_names.hpp"
#include "graze/report/picture_style.hpp"
#include "graze/report/pictures.hpp"
#include "graze/report/special_marks.hpp"

namespace graze {
namespace {

enum Kind : std::size_t { kStable, kUnstable, kOpen, kVirtual, kKinds };

struct KindStyle {
  const char* name;
  const char* title;
  const char* line;
  const char* colour;
};

// In the order in which they are drawn: what is seen in an experiment lies on top.
constexpr std::array<std::size_t, kKinds> kOrder = {kVirtual, kOpen, kUnstable, kStable};

KindStyle style_of(std::size_t kind) {
  switch (kind) {
    case kStable:
      return {"stable", "stable", "lw 2.2 dt solid", kBlue};
    case kUnstable:
      return {"unstable", "unstable", "lw 1.8 dt (8,5)", kVermillion};
    case kOpen:
      return {"open", "stability open", "lw 1.8 dt (2,3)", kBlack};
    default:
      return {"virtual", "virtual", "lw 0.9 dt solid", kGrey};
  }
}

std::string line_style(std::size_t kind) {
  return fmt::format("with lines {} lc rgb '{}'", style_of(kind).line, style_of(kind).colour);
}

Kind kind_of(const Orbit& orbit) {
  if (!orbit.admissible) return kVirtual;
  if (!orbit.stable) return kOpen;
  return *orbit.stable ? kStable : kUnstable;
}

// A point of the curve; special points belong to both sides and have no kind of their own.
struct Node {
  double x = 0.0, y = 0.0;
  std::optional<Kind> kind;
};

double first_speed(const OrbitBranchPoint& point) {
  return point.orbit.impacts.empty() ? std::nan("") : leading_impact(point.orbit).speed;
}

struct Axes {
  AxisUnit parameter, speed;
  AxisRange x, y;
};

// Puts the special point where it lies on the curve: on the node that it is, or between the two
// nodes that it makes the smallest detour from.
void insert_special(std::vector<Node>& nodes, const Node& special, const Axes& axes) {
  const auto distance = [&](const Node& a, const Node& b) {
    return std::hypot((a.x - b.x) / axes.x.span(), (a.y - b.y) / axes.y.span());
  };
  double least = std::numeric_limits<double>::infinity();
  std::size_t place = nodes.size();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (distance(nodes[i], special) == 0.0) {
      nodes[i].kind.reset();
      return;
    }
    if (i + 1 == nodes.size()) break;
    const double detour = distance(nodes[i], special) + distance(special, nodes[i + 1]) -
                          distance(nodes[i], nodes[i + 1]);
    if (detour < least) {
      least = detour;
      place = i + 1;
    }
  }
  // Not a part of this curve unless it nearly lies on it.
  if (least < 0.05) nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(place), special);
}

const SpecialMark kVirtualMark = {"", 7, 0.6, kGrey, 0};

constexpr std::size_t kColumns = 2;  // of the legend: the names of special points are long

class BranchesPicture {
 public:
  explicit BranchesPicture(const BranchRecord& record) : record_(record) {
    double fastest = 0.0;
    for (const OrbitBranch& branch : record.traced.branches)
      for (const OrbitBranchPoint& point : branch.points)
        fastest = std::fmax(fastest, std::abs(first_speed(point)));
    axes_.parameter = axis_unit(record.unit, std::max(std::abs(record.from), std::abs(record.to)));
    axes_.speed = axis_unit("m/s", fastest);
    axes_.x.include(axes_.parameter.factor * record.from);
    axes_.x.include(axes_.parameter.factor * record.to);
    axes_.x.settle(0.0);
    axes_.y.include(0.0);
    for (const OrbitBranch& branch : record.traced.branches)
      for (const OrbitBranchPoint& point : branch.points) axes_.y.include(node(point).y);
    if (!(axes_.y.span() > 0.0)) axes_.y.high = 1.0;
    for (const OrbitBranch& branch : record.traced.branches) add_curve(branch);
    for (const OrbitBranch& branch : record.traced.branches) add_special(branch);
  }

  GnuplotScript script() {
    set_style(script_);
    for (std::size_t kind = 0; kind < kKinds; ++kind) write_kind(kind);
    for (const auto& [kind, marks] : marks_) script_.data(label_of(kind), marks);
    if (!virtual_marks_.empty()) script_.data("virtual_marks", virtual_marks_);
    set_axes();
    script_.plot(layers());
    return script_;
  }

 private:
  Node node(const OrbitBranchPoint& point) const {
    return {axes_.parameter.factor * point.value, axes_.speed.factor * first_speed(point),
            kind_of(point.orbit)};
  }

  std::vector<Node> nodes_of(const OrbitBranch& branch) const {
    std::vector<Node> nodes;
    for (const OrbitBranchPoint& point : branch.points) nodes.push_back(node(point));
    // Where it joins orbits of half the period a multiplier is 1; that says nothing of the branch.
    if (branch.ends[0] == OrbitBranchEnd::kPeriodDoubling) nodes.front().kind.reset();
    if (branch.ends[1] == OrbitBranchEnd::kPeriodDoubling) nodes.back().kind.reset();
    for (const SpecialPoint& special : branch.special) {
      Node place = node(special.at);
      place.kind.reset();
      insert_special(nodes, place, axes_);
    }
    return nodes;
  }

  void add_curve(const OrbitBranch& branch) {
    const std::vector<Node> nodes = nodes_of(branch);
    const bool lone = std::all_of(nodes.begin(), nodes.end(), [&](const Node& other) {
      return other.x == nodes[0].x && other.y == nodes[0].y;
    });
    if (lone && !nodes.empty())
      return lone_[kind_of(branch.points.front().orbit)].row({nodes[0].x, nodes[0].y});
    // Between two nodes the curve is what its first node is; where that has no kind, the second.
    std::optional<Kind> current;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      std::optional<Kind> kind = nodes[i].kind ? nodes[i].kind : nodes[i + 1].kind;
      if (!kind) kind = current.value_or(kind_of(branch.points.front().orbit));
      PlotTable& curve = curves_[*kind];
      if (kind != current) {
        curve.gap();
        curve.row({nodes[i].x, nodes[i].y});
      }
      curve.row({nodes[i + 1].x, nodes[i + 1].y});
      current = kind;
    }
    for (PlotTable& curve : curves_) curve.gap();
  }

  void add_special(const OrbitBranch& branch) {
    for (const SpecialPoint& special : branch.special) {
      const Node at = node(special.at);
      if (!special.at.orbit.admissible)
        virtual_marks_.row({at.x, at.y});
      else
        marks_[special.kind].row({at.x, at.y});
    }
  }

  void set_axes() {
    AxisRange y = axes_.y;
    const double room = 0.06 * y.span();
    y.high += room;
    if (y.low < 0.0 || marks_.count(SpecialKind::kGrazing) > 0) {
      y.low -= room;
      script_.command(
          fmt::format("set arrow from graph 0, first 0 to graph 1, first 0 nohead back "
                      "lw 0.5 lc rgb '{}'",
                      kGrey));
    }
    Margins margins;
    margins.bottom += legend_height(legend().size(), kColumns);
    if (record_.traced.parameter == "forcing.frequency") margins.top = 0.145;
    set_margins(script_, margins);
    set_legend(script_, margins, kColumns);
    script_.command("set xrange " + axes_.x.text());
    script_.command(fmt::format("set xtics {:.6g}", axes_.x.tic_step(7)));
    script_.command("set yrange " + y.text());
    script_.command(fmt::format("set ytics {:.6g}", y.tic_step(8)));
    script_.command("set xlabel " +
                    axis_label(parameter_title(record_.traced.parameter), axes_.parameter.unit));
    name_vertical_axis(script_, "impact speed", axes_.speed.unit);
    if (record_.traced.parameter == "forcing.frequency") set_hertz_axis();
    if (record_.traced.branches.empty())
      script_.command("set label 'no branch was found' at graph 0.5, graph 0.5 center");
  }

  void write_kind(std::size_t kind) {
    const std::string name = style_of(kind).name;
    if (!curves_[kind].empty()) script_.data(name, curves_[kind]);
    if (!lone_[kind].empty()) script_.data("lone_" + name, lone_[kind]);
  }

  void set_hertz_axis() {
    const AxisRange hertz{axes_.x.low / kTurn, axes_.x.high / kTurn};
    script_.command("set border 7");
    script_.command("set x2range " + hertz.text());
    script_.command(fmt::format("set x2tics {:.6g}", hertz.tic_step(9)));
    script_.command("set x2label 'forcing frequency (Hz)'");
  }

  std::string mark(const SpecialMark& style) const {
    return fmt::format("with points pt {} ps {:.2f} lw 1.2 lc rgb '{}'", style.point,
                       style.size * mark_size(), style.colour);
  }

  double mark_size() const {
    std::size_t count = 0;
    for (const OrbitBranch& branch : record_.traced.branches) count += branch.special.size();
    return crowded_mark_size(count);
  }

  std::vector<std::string> layers() const {
    std::vector<std::string> layers;
    for (std::size_t kind : kOrder) {
      const std::string name = style_of(kind).name;
      if (!curves_[kind].empty()) layers.push_back("$" + name + " " + line_style(kind));
      if (!lone_[kind].empty())
        layers.push_back(fmt::format("$lone_{} with points pt 7 ps 0.4 lc rgb '{}'", name,
                                     style_of(kind).colour));
    }
    if (!virtual_marks_.empty()) layers.push_back("$virtual_marks " + mark(kVirtualMark));
    for (const auto& [kind, points] : marks_) {
      const SpecialMark style = special_mark(label_of(kind));
      // Filled with the paper's white, so that the curve does not run through an outline.
      if (style.ground > 0)
        layers.push_back(fmt::format("${} with points pt {} ps {:.2f} lc rgb '#FFFFFF'",
                                     label_of(kind), style.ground, style.size * mark_size()));
      layers.push_back("$" + label_of(kind) + " " + mark(style));
    }
    for (const std::string& entry : legend()) layers.push_back(entry);
    return layers;
  }

  std::vector<std::string> legend() const {
    std::vector<std::string> entries;
    for (std::size_t kind = 0; kind < kKinds; ++kind)
      if (!curves_[kind].empty() || !lone_[kind].empty())
        entries.push_back(fmt::format("NaN {} title '{}'", line_style(kind), style_of(kind).title));
    for (const auto& [kind, points] : marks_) {
      const SpecialMark style = special_mark(label_of(kind));
      entries.push_back(fmt::format("NaN {} title '{}'", mark(style), style.title));
    }
    if (!virtual_marks_.empty())
      entries.push_back("NaN " + mark(kVirtualMark) + " title 'virtual special point'");
    return entries;
  }

  const BranchRecord& record_;
  Axes axes_;
  std::array<PlotTable, kKinds> curves_;
  std::array<PlotTable, kKinds> lone_;      // branches of a single point
  std::map<SpecialKind, PlotTable> marks_;  // special points of orbits
  PlotTable virtual_marks_;
  GnuplotScript script_;
};

}  // namespace

void draw_branches(const std::string& file, const BranchRecord& record) {
  draw_picture(file, BranchesPicture(record).script());
}

}  // namespace graze
