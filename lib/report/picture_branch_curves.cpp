#include "graze/report/picture_branch_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "graze/bifurcation/special_names.hpp"

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
  static const std::array<KindStyle, kKinds> kStyles = {
      {{"virtual", "virtual", 0.9, "solid", kGrey},
       {"open", "stability open", 1.8, "(2,3)", kBlack},
       {"unstable", "unstable", 1.8, "(8,5)", kVermillion},
       {"stable", "stable", 2.2, "solid", kBlue}}};
  return kStyles[kind];
}

BranchCurves::Kind BranchCurves::kind_of(const Orbit& orbit) {
  if (!orbit.admissible) return kVirtual;
  if (!orbit.stable) return kOpen;
  return *orbit.stable ? kStable : kUnstable;
}

BranchCurves::BranchCurves(const std::vector<OrbitBranch>& branches,
                           const std::vector<DiagramCurve>& curves, const PicturePlane& plane,
                           double weight, std::string prefix)
    : plane_(plane), weight_(weight), prefix_(std::move(prefix)) {
  for (std::size_t i = 0; i < branches.size(); ++i) add(branches[i], curves[i]);
}

BranchCurves::Node BranchCurves::node(const OrbitBranchPoint& point,
                                      const std::vector<double>& heights) const {
  Node node{plane_.x_factor * point.value, heights, kind_of(point.orbit)};
  for (double& y : node.y) y *= plane_.y_factor;
  return node;
}

double BranchCurves::distance(const Node& a, const Node& b) const {
  return std::hypot((a.x - b.x) / plane_.x.span(), (a.y.front() - b.y.front()) / plane_.y.span());
}

void BranchCurves::add(const OrbitBranch& branch, const DiagramCurve& curve) {
  std::vector<Node> nodes;
  for (std::size_t k = 0; k < branch.points.size(); ++k) {
    nodes.push_back(node(branch.points[k], curve.points[k]));
    if (k > 0) align(nodes[k - 1], nodes[k]);
  }
  if (nodes.empty()) return;
  const Kind first = *nodes.front().kind;
  // Where it joins orbits of half the period a multiplier is 1; that says nothing of the branch.
  if (branch.ends[0] == OrbitBranchEnd::kPeriodDoubling) nodes.front().kind.reset();
  if (branch.ends[1] == OrbitBranchEnd::kPeriodDoubling) nodes.back().kind.reset();
  // Nor where a multiplier is on the circle in a single point: it passes there.
  for (std::size_t k = 1; k + 1 < nodes.size(); ++k)
    if (nodes[k].kind == kOpen && nodes[k - 1].kind != kOpen && nodes[k + 1].kind != kOpen)
      nodes[k].kind.reset();
  for (std::size_t k = 0; k < branch.special.size(); ++k)
    add_special(branch.special[k], curve.special[k], nodes);
  std::size_t most = 0;
  for (const Node& node : nodes) most = std::max(most, node.y.size());
  for (std::size_t j = 0; j < most; ++j) draw(nodes, j, first);
}

void BranchCurves::add_special(const SpecialPoint& special, const std::vector<double>& heights,
                               std::vector<Node>& nodes) {
  Node place = node(special.at, heights);
  place.kind.reset();
  insert(nodes, place);
  PlotTable& table = special.at.orbit.admissible ? marks_[special.kind] : virtual_marks_;
  // One mark is enough for all that a chatter shows.
  const std::size_t marks =
      special.at.orbit.sticking ? std::min<std::size_t>(place.y.size(), 1) : place.y.size();
  for (std::size_t j = 0; j < marks; ++j) table.row({place.x, place.y[j]});
  ++marked_;
}

// The impacts of an orbit are listed by their phases, and the first may become the last from one
// point to the next: turned so that each stays near itself.
void BranchCurves::align(const Node& before, Node& node) {
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

// On the node that it is, or between the two that it makes the smallest detour from.
void BranchCurves::insert(std::vector<Node>& nodes, Node& special) const {
  if (special.y.empty()) return;
  double least = std::numeric_limits<double>::infinity();
  std::size_t place = nodes.size();
  Node best = special;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].y.size() != special.y.size()) continue;
    align(nodes[i], special);
    if (distance(nodes[i], special) == 0.0) {
      nodes[i].kind.reset();
      return;
    }
    if (i + 1 == nodes.size() || nodes[i + 1].y.size() != special.y.size()) continue;
    const double detour = distance(nodes[i], special) + distance(special, nodes[i + 1]) -
                          distance(nodes[i], nodes[i + 1]);
    if (detour >= least) continue;
    least = detour;
    place = i + 1;
    best = special;
  }
  special = best;
  // Not a part of this curve unless it nearly lies on it.
  if (least < 0.05) nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(place), special);
}

// The j-th curve of the branch. Between two nodes it is what its first node is; where that has no
// kind, the second.
void BranchCurves::draw(const std::vector<Node>& nodes, std::size_t j, Kind first) {
  const Node& start = nodes.front();
  const bool lone = std::all_of(nodes.begin(), nodes.end(), [&](const Node& other) {
    return other.x == start.x && other.y.size() > j && start.y.size() > j &&
           other.y[j] == start.y[j];
  });
  if (lone) return lone_[first].row({start.x, start.y[j]});
  Kind latest = first;
  bool drawing = false;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Node &a = nodes[i], &b = nodes[i + 1];
    if (a.y.size() <= j || b.y.size() <= j) {
      drawing = false;
      continue;
    }
    const Kind kind = a.kind ? *a.kind : b.kind ? *b.kind : latest;
    if (!drawing || kind != latest) {
      lines_[kind].gap();
      lines_[kind].row({a.x, a.y[j]});
      latest = kind;
      drawing = true;
    }
    lines_[kind].row({b.x, b.y[j]});
  }
}

void BranchCurves::write(GnuplotScript& script) const {
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
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
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
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
  for (std::size_t kind = kKinds; kind-- > 0;)
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
