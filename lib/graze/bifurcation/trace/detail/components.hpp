// Which branches are connected: the numbers of their components.
#pragma once

#include <utility>
#include <vector>

#include "graze/bifurcation/problem/orbit_branch.hpp"

namespace graze {

// Two branches belong to one component if their names are equal, or if both pass a branch point
// that is the same orbit at the same value.
class Components {
 public:
  // `range` of the parameter; `speed_scale`, m/s, of the forced motion.
  Components(double range, double speed_scale) : range_(range), speed_scale_(speed_scale) {}

  // Adds a branch, which must outlive this, under a name.
  void add(const OrbitBranch& branch, const std::pair<int, int>& name);
  // Component of each branch, in the order of their adding; numbered from 1 by their first branch.
  std::vector<int> numbers() const;

 private:
  bool cross(const OrbitBranch& a, const OrbitBranch& b) const;

  double range_, speed_scale_;
  std::vector<const OrbitBranch*> branches_;
  std::vector<std::pair<int, int>> names_;
};

}  // namespace graze
