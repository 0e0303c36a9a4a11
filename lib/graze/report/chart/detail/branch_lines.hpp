// Branches of orbits as lines over a parameter, divided by stability, and the positions of their
// special points: the geometry of every picture of branches.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "graze/record/study_records.hpp"

namespace graze {

// In the order of drawing: orbits that an experiment shows lie on top.
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

// A special point with its mark, SI.
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

// `curves`: one for each branch. Distances along a branch are relative to the spans of the axes,
// SI.
BranchLines branch_lines(const std::vector<OrbitBranch>& branches,
                         const std::vector<DiagramCurve>& curves, double across, double up);

}  // namespace graze
