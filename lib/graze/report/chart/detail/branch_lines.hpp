// Branches of orbits as lines over a parameter, parted by stability, and where their special points
// lie on them: the geometry that every picture of branches draws.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "graze/record/study_records.hpp"

namespace graze {

// In the order in which they are drawn: what is seen in an experiment lies on top.
enum LineKind : std::size_t { kVirtualLine, kOpenLine, kUnstableLine, kStableLine, kLineKinds };

LineKind line_kind(const Orbit& orbit);

// A piece of a branch of one kind, SI; of a single node where the branch is a single point.
struct BranchLine {
  struct Node {
    double x = 0.0, y = 0.0;
    int point = 0;  // of the branch, index from 0; of its special points: -1 - index
    int which = 0;  // of the values that the curve has there
  };
  std::size_t branch = 0;  // index from 0
  LineKind kind = kVirtualLine;
  std::vector<Node> nodes;

  bool is_dot() const { return nodes.size() == 1; }
};

// A special point as it is marked, SI.
struct BranchMark {
  std::size_t branch = 0, special = 0;  // indices from 0
  double x = 0.0;
  std::vector<double> y;
  std::vector<int> which = {};  // of the values that the curve has there, each
};

struct BranchLines {
  std::vector<BranchLine> lines;
  std::vector<BranchMark> marks;
};

// `curves`: one a branch. Distances along a branch are measured in parts of what the axes span, SI.
BranchLines branch_lines(const std::vector<OrbitBranch>& branches,
                         const std::vector<DiagramCurve>& curves, double across, double up);

}  // namespace graze
