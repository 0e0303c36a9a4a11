#include "graze/bifurcation/trace/detail/components.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "graze/orbit/problem/orbit_identity.hpp"

namespace graze {

void Components::add(const OrbitBranch& branch, const std::pair<int, int>& name) {
  branches_.push_back(&branch);
  names_.push_back(name);
}

bool Components::cross(const OrbitBranch& a, const OrbitBranch& b) const {
  for (const SpecialPoint& x : a.special) {
    if (x.kind != SpecialKind::kBranchPoint) continue;
    for (const SpecialPoint& y : b.special) {
      // On either branch the point is as accurate as its orbit.
      if (y.kind == SpecialKind::kBranchPoint &&
          std::abs(x.at.value - y.at.value) <= kSameOrbit * range_ &&
          same_orbit(x.at.orbit, y.at.orbit, speed_scale_))
        return true;
    }
  }
  return false;
}

std::vector<int> Components::numbers() const {
  // Union-find: each branch points to an earlier one of its component, the first to itself.
  std::vector<std::size_t> earlier(branches_.size());
  const auto first = [&earlier](std::size_t i) {
    while (earlier[i] != i) i = earlier[i];
    return i;
  };
  for (std::size_t i = 0; i < branches_.size(); ++i) {
    earlier[i] = i;
    for (std::size_t j = 0; j < i; ++j) {
      if (names_[i] != names_[j] && !cross(*branches_[i], *branches_[j])) continue;
      const std::size_t a = first(i), b = first(j);
      earlier[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<int> numbers(branches_.size());
  int last = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = first(i) == i ? ++last : numbers[first(i)];
  return numbers;
}

}  // namespace graze
