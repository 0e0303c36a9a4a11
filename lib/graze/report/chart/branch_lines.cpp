#include "graze/report/chart/detail/branch_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace graze {
namespace {

// A point of a branch; special points belong to both sides and have no kind of their own.
struct Node {
  double x = 0.0;
  std::vector<double> y;
  std::optional<LineKind> kind;
  int point = 0;         // as of BranchLine::Node
  std::size_t turn = 0;  // that y is turned by

  // The j-th value as a branch's line has it.
  BranchLine::Node at(std::size_t j) const {
    return {x, y[j], point, static_cast<int>((j + turn) % y.size())};
  }
};

// The impacts of an orbit are sorted by phase, and the first may become the last from one point to
// the next: rotates the list so that each impact stays near itself.
void align(const Node& before, Node& node) {
  if (node.y.size() != before.y.size() || node.y.size() < 2) return;
  std::vector<double> best = node.y;
  double least = std::numeric_limits<double>::infinity();
  const std::size_t from = node.turn;
  for (std::size_t turn = 0; turn < node.y.size(); ++turn) {
    double distance = 0.0;
    for (std::size_t j = 0; j < node.y.size(); ++j) distance += std::abs(node.y[j] - before.y[j]);
    if (distance < least) {
      least = distance;
      best = node.y;
      node.turn = (from + turn) % node.y.size();
    }
    std::rotate(node.y.begin(), node.y.begin() + 1, node.y.end());
  }
  node.y = best;
}

class LineMaker {
 public:
  LineMaker(double across, double up) : across_(across), up_(up) {}

  void add(std::size_t index, const OrbitBranch& branch, const DiagramCurve& curve);
  BranchLines take() { return std::move(made_); }

 private:
  double distance(const Node& a, const Node& b) const;
  void add_special(const SpecialPoint& special, int index, const std::vector<double>& heights,
                   std::vector<Node>& nodes);
  void insert(std::vector<Node>& nodes, Node& special) const;
  void draw(const std::vector<Node>& nodes, std::size_t j, LineKind first);

  double across_, up_;  // what the axes span
  std::size_t branch_ = 0;
  BranchLines made_;
};

double LineMaker::distance(const Node& a, const Node& b) const {
  return std::hypot((a.x - b.x) / across_, (a.y.front() - b.y.front()) / up_);
}

void LineMaker::add(std::size_t index, const OrbitBranch& branch, const DiagramCurve& curve) {
  branch_ = index;
  std::vector<Node> nodes;
  for (std::size_t k = 0; k < branch.points.size(); ++k) {
    const OrbitBranchPoint& point = branch.points[k];
    nodes.push_back({point.value, curve.points[k], line_kind(point.orbit), static_cast<int>(k)});
    if (k > 0) align(nodes[k - 1], nodes[k]);
  }
  if (nodes.empty()) return;
  const LineKind first = *nodes.front().kind;
  // Where it joins orbits of half the period a multiplier is 1, whatever the stability of the
  // branch.
  if (branch.ends[0] == OrbitBranchEnd::kPeriodDoubling) nodes.front().kind.reset();
  if (branch.ends[1] == OrbitBranchEnd::kPeriodDoubling) nodes.back().kind.reset();
  // Likewise a multiplier on the circle at a single point, where it crosses.
  for (std::size_t k = 1; k + 1 < nodes.size(); ++k)
    if (nodes[k].kind == kOpenLine && nodes[k - 1].kind != kOpenLine &&
        nodes[k + 1].kind != kOpenLine)
      nodes[k].kind.reset();
  for (std::size_t k = 0; k < branch.special.size(); ++k)
    add_special(branch.special[k], static_cast<int>(k), curve.special[k], nodes);
  std::size_t most = 0;
  for (const Node& node : nodes) most = std::max(most, node.y.size());
  for (std::size_t j = 0; j < most; ++j) draw(nodes, j, first);
}

void LineMaker::add_special(const SpecialPoint& special, int index,
                            const std::vector<double>& heights, std::vector<Node>& nodes) {
  Node place{special.at.value, heights, {}, -1 - index};
  insert(nodes, place);
  BranchMark mark{branch_, static_cast<std::size_t>(index), place.x, {}};
  // One mark is enough for all that a chatter shows.
  const std::size_t count =
      special.at.orbit.sticks() ? std::min<std::size_t>(place.y.size(), 1) : place.y.size();
  for (std::size_t j = 0; j < count; ++j) {
    mark.y.push_back(place.y[j]);
    mark.which.push_back(place.at(j).which);
  }
  made_.marks.push_back(std::move(mark));
}

// Inserts it at its node, or between the two nodes with the smallest detour.
void LineMaker::insert(std::vector<Node>& nodes, Node& special) const {
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

// The j-th curve of the branch. A line between two nodes has the kind of the first; if that has
// none, of the second.
void LineMaker::draw(const std::vector<Node>& nodes, std::size_t j, LineKind first) {
  const Node& start = nodes.front();
  const bool lone = std::all_of(nodes.begin(), nodes.end(), [&](const Node& other) {
    return other.x == start.x && other.y.size() > j && start.y.size() > j &&
           other.y[j] == start.y[j];
  });
  if (lone) {
    made_.lines.push_back({branch_, first, {start.at(j)}});
    return;
  }
  LineKind latest = first;
  bool drawing = false;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Node &a = nodes[i], &b = nodes[i + 1];
    if (a.y.size() <= j || b.y.size() <= j) {
      drawing = false;
      continue;
    }
    const LineKind kind = a.kind ? *a.kind : b.kind ? *b.kind : latest;
    if (!drawing || kind != latest) {
      made_.lines.push_back({branch_, kind, {a.at(j)}});
      latest = kind;
      drawing = true;
    }
    made_.lines.back().nodes.push_back(b.at(j));
  }
}

}  // namespace

LineKind line_kind(const Orbit& orbit) {
  if (!orbit.admissible) return kVirtualLine;
  if (!orbit.stable) return kOpenLine;
  return *orbit.stable ? kStableLine : kUnstableLine;
}

BranchLines branch_lines(const std::vector<OrbitBranch>& branches,
                         const std::vector<DiagramCurve>& curves, double across, double up) {
  LineMaker maker(across, up);
  for (std::size_t i = 0; i < branches.size(); ++i) maker.add(i, branches[i], curves[i]);
  return maker.take();
}

}  // namespace graze
