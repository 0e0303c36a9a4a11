#include "graze/report/picture/detail/picture_branch_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "graze/bifurcation/problem/detail/special_names.hpp"
#include "graze/record/names/detail/sweep_names.hpp"
#include "graze/report/picture/detail/gnuplot_looks.hpp"

namespace graze {
namespace {

const Look& look_of(std::size_t kind) { return line_looks()[kind]; }

std::string branch_name(const OrbitBranch& branch) {
  return orbit_label(branch.pattern.period, branch.pattern.impacts(), branch.sticks());
}

}  // namespace

BranchCurves::BranchCurves(const std::vector<OrbitBranch>& branches,
                           const std::vector<DiagramCurve>& curves, const PicturePlane& plane,
                           double weight, std::string prefix)
    : branches_(branches), weight_(weight), prefix_(std::move(prefix)) {
  if (curves.empty()) return;
  made_ = branch_lines(branches, curves, plane);
  for (const BranchLine& line : made_.lines) {
    PlotTable& table = line.is_dot() ? lone_[line.kind] : lines_[line.kind];
    if (!line.is_dot()) table.gap();
    for (const BranchLine::Node& node : line.nodes) table.row({node.x, node.y});
  }
  for (const BranchMark& mark : made_.marks) {
    const SpecialPoint& special = branches[mark.branch].special[mark.special];
    PlotTable& table = special.at.orbit.admissible ? marks_[special.kind] : virtual_marks_;
    for (const double y : mark.y) table.row({mark.x, y});
    ++marked_;
  }
}

void BranchCurves::write(GnuplotScript& script) const {
  for (std::size_t kind = 0; kind < kLineKinds; ++kind) {
    script.data(prefix_ + look_of(kind).id, lines_[kind]);
    script.data(prefix_ + "lone_" + look_of(kind).id, lone_[kind]);
  }
  for (const auto& [kind, table] : marks_) script.data(prefix_ + label_of(kind), table);
  script.data(prefix_ + "virtual_marks", virtual_marks_);
}

std::vector<std::string> BranchCurves::layers() const {
  std::vector<std::string> layers;
  for (std::size_t kind = 0; kind < kLineKinds; ++kind) {
    const Look& look = look_of(kind);
    layers.push_back("$" + prefix_ + look.id + " " + line_of(look, weight_));
    layers.push_back(fmt::format("${}lone_{} with points pt 7 ps 0.4 lc rgb '{}'", prefix_, look.id,
                                 look.colour));
  }
  const double size = crowded_mark_size(marked_);
  add_marks(layers, "$" + prefix_ + "virtual_marks", virtual_special_look(), size);
  for (const auto& [kind, table] : marks_)
    add_marks(layers, "$" + prefix_ + label_of(kind), special_look(label_of(kind)), size);
  return layers;
}

std::vector<std::string> BranchCurves::legend() const {
  std::vector<std::string> entries;
  const auto add = [&](const std::string& how, const std::string& title) {
    entries.push_back("NaN " + how + " title " + gnuplot_string(title));
  };
  for (std::size_t kind = kLineKinds; kind-- > 0;)
    if (!lines_[kind].empty() || !lone_[kind].empty())
      add(line_of(look_of(kind), weight_), look_of(kind).title);
  const double size = crowded_mark_size(marked_);
  for (const auto& [kind, table] : marks_) {
    Look look = special_look(label_of(kind));
    if (!table.empty()) add(mark_of(look, size), look.id.empty() ? label_of(kind) : look.title);
  }
  if (!virtual_marks_.empty())
    add(mark_of(virtual_special_look(), size), virtual_special_look().title);
  return entries;
}

void BranchCurves::label(GnuplotScript& script, LabelRoom& room, LabelChoice choice) const {
  for (const BranchLine& line : made_.lines)
    for (std::size_t i = 0; i + 1 < line.nodes.size(); ++i)
      room.add_line(line.nodes[i].x, line.nodes[i].y, line.nodes[i + 1].x, line.nodes[i + 1].y);
  for (const BranchMark& mark : made_.marks)
    for (const double y : mark.y) room.add_mark(mark.x, y);
  if (choice == LabelChoice::kNone) return;
  std::vector<LabelRoom::NamedPoint> points;
  for (const BranchMark& mark : made_.marks) {
    const SpecialPoint& special = branches_[mark.branch].special[mark.special];
    if (!mark.y.empty() && special.at.orbit.admissible)
      points.push_back({mark.x, mark.y.front(), special.id});
  }
  room.name(script, points);
  // Beside many ids those of the orbits would be lost.
  constexpr std::size_t kDozen = 12;
  if (choice == LabelChoice::kAll && points.size() <= kDozen) label_branches(script, room);
}

// Each branch once, on its line of the best kind.
void BranchCurves::label_branches(GnuplotScript& script, LabelRoom& room) const {
  constexpr std::size_t kPlaces = 24;
  for (std::size_t b = 0; b < branches_.size(); ++b) {
    int best = -1;
    for (const BranchLine& line : made_.lines)
      if (line.branch == b) best = std::max(best, static_cast<int>(line.kind));
    std::vector<std::pair<double, double>> places;
    std::size_t nodes = 0;
    for (const BranchLine& line : made_.lines)
      if (line.branch == b && static_cast<int>(line.kind) == best) nodes += line.nodes.size();
    std::size_t at = 0;
    const std::size_t stride = nodes / kPlaces + 1;
    for (const BranchLine& line : made_.lines)
      if (line.branch == b && static_cast<int>(line.kind) == best)
        for (const BranchLine::Node& node : line.nodes)
          if (at++ % stride == stride / 2) places.emplace_back(node.x, node.y);
    room.write(script, branch_name(branches_[b]), places);
  }
}

}  // namespace graze
