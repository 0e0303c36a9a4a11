#include "graze/report/picture/detail/picture_branch_curves.hpp"

#include <fmt/format.h>

#include <utility>

#include "graze/bifurcation/problem/detail/special_names.hpp"

namespace graze {
namespace {

const SpecialMark kVirtualMark = {"", 7, 0.6, kGrey};

}  // namespace

struct BranchCurves::KindStyle {
  const char *name, *title;
  double width;
  const char *dashes, *colour;
};

const BranchCurves::KindStyle& BranchCurves::style_of(std::size_t kind) {
  static const std::array<KindStyle, kLineKinds> kStyles = {
      {{"virtual", "virtual", 0.9, "solid", kGrey},
       {"open", "stability open", 1.8, "(2,3)", kBlack},
       {"unstable", "unstable", 1.8, "(8,5)", kVermillion},
       {"stable", "stable", 2.2, "solid", kBlue}}};
  return kStyles[kind];
}

BranchCurves::BranchCurves(const std::vector<OrbitBranch>& branches,
                           const std::vector<DiagramCurve>& curves, const PicturePlane& plane,
                           double weight, std::string prefix)
    : weight_(weight), prefix_(std::move(prefix)) {
  const BranchLines made = branch_lines(branches, curves, plane);
  for (const BranchLine& line : made.lines) {
    PlotTable& table = line.is_dot() ? lone_[line.kind] : lines_[line.kind];
    if (!line.is_dot()) table.gap();
    for (const BranchLine::Node& node : line.nodes) table.row({node.x, node.y});
  }
  for (const BranchMark& mark : made.marks) {
    const SpecialPoint& special = branches[mark.branch].special[mark.special];
    PlotTable& table = special.at.orbit.admissible ? marks_[special.kind] : virtual_marks_;
    for (const double y : mark.y) table.row({mark.x, y});
    ++marked_;
  }
}

void BranchCurves::write(GnuplotScript& script) const {
  for (std::size_t kind = 0; kind < kLineKinds; ++kind) {
    const std::string name = prefix_ + style_of(kind).name;
    if (!lines_[kind].empty()) script.data(name, lines_[kind]);
    if (!lone_[kind].empty()) script.data("lone_" + name, lone_[kind]);
  }
  for (const auto& [kind, table] : marks_)
    if (!table.empty()) script.data(prefix_ + label_of(kind), table);
  if (!virtual_marks_.empty()) script.data(prefix_ + "virtual_marks", virtual_marks_);
}

std::string BranchCurves::line(std::size_t kind) const {
  const KindStyle& style = style_of(kind);
  return fmt::format("with lines lw {:.3g} dt {} lc rgb '{}'", weight_ * style.width, style.dashes,
                     style.colour);
}

std::string BranchCurves::mark(const SpecialMark& mark) const {
  return fmt::format("with points pt {} ps {:.2f}*mark lw {} lc rgb '{}'", mark.point,
                     mark.size * crowded_mark_size(marked_), mark.width, mark.colour);
}

std::vector<std::string> BranchCurves::layers() const {
  std::vector<std::string> layers;
  for (std::size_t kind = 0; kind < kLineKinds; ++kind) {
    const std::string name = prefix_ + style_of(kind).name;
    if (!lines_[kind].empty()) layers.push_back("$" + name + " " + line(kind));
    if (!lone_[kind].empty())
      layers.push_back(
          fmt::format("$lone_{} with points pt 7 ps 0.4 lc rgb '{}'", name, style_of(kind).colour));
  }
  if (!virtual_marks_.empty())
    layers.push_back("$" + prefix_ + "virtual_marks " + mark(kVirtualMark));
  for (const auto& [kind, table] : marks_) {
    if (table.empty()) continue;
    const SpecialMark style = special_mark(label_of(kind));
    const std::string name = "$" + prefix_ + label_of(kind);
    // Filled with the paper's white, so that the curve does not run through the outline.
    if (style.ground > 0)
      layers.push_back(fmt::format("{} with points pt {} ps {:.2f}*mark lc rgb '#FFFFFF'", name,
                                   style.ground, style.size * crowded_mark_size(marked_)));
    layers.push_back(name + " " + mark(style));
  }
  return layers;
}

std::vector<std::string> BranchCurves::legend() const {
  std::vector<std::string> entries;
  for (std::size_t kind = kLineKinds; kind-- > 0;)
    if (!lines_[kind].empty() || !lone_[kind].empty())
      entries.push_back(fmt::format("NaN {} title '{}'", line(kind), style_of(kind).title));
  for (const auto& [kind, table] : marks_) {
    const SpecialMark style = special_mark(label_of(kind));
    if (!table.empty())
      entries.push_back(fmt::format("NaN {} title {}", mark(style), gnuplot_string(style.title)));
  }
  if (!virtual_marks_.empty())
    entries.push_back("NaN " + mark(kVirtualMark) + " title 'virtual special point'");
  return entries;
}

}  // namespace graze
