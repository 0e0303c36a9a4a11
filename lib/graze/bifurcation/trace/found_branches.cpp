#include "graze/bifurcation/trace/detail/found_branches.hpp"

#include <algorithm>

#include "graze/bifurcation/problem/detail/special_names.hpp"

namespace graze {
namespace {

double lowest_value(const OrbitBranch& branch) {
  const auto less = [](const OrbitBranchPoint& a, const OrbitBranchPoint& b) {
    return a.value < b.value;
  };
  return std::min_element(branch.points.begin(), branch.points.end(), less)->value;
}

bool comes_before(const OrbitBranch& a, const OrbitBranch& b) {
  const ImpactPattern &pa = a.pattern, &pb = b.pattern;
  if (pa.period != pb.period) return pa.period < pb.period;
  // Branches that stick come last.
  if (pa.stops.empty() != pb.stops.empty()) return pb.stops.empty();
  if (pa.stops.size() != pb.stops.size()) return pa.stops.size() < pb.stops.size();
  if (pa.stops != pb.stops) return pa.stops < pb.stops;
  return lowest_value(a) < lowest_value(b);
}

// A branch that was switched onto is connected to its origin. Branches that were traced separately
// may be parts of one component nevertheless.
std::pair<int, int> component_of(const std::vector<FoundBranch>& found, std::size_t index,
                                 const ConnectedSet& set_of) {
  while (found[index].origin_branch >= 0)
    index = static_cast<std::size_t>(found[index].origin_branch);
  const FoundBranch& first = found[index];
  return set_of(first.branch()).value_or(std::pair(-1, first.trace));
}

}  // namespace

std::vector<OrbitBranch> put_in_order(std::vector<FoundBranch> found, Components components,
                                      const ConnectedSet& set_of) {
  std::vector<std::size_t> order(found.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return comes_before(found[a].branch(), found[b].branch());
  });
  for (const std::size_t i : order)
    components.add(found[i].branch(), component_of(found, i, set_of));
  const std::vector<int> numbers = components.numbers();
  SpecialNames names;
  for (std::size_t k = 0; k < order.size(); ++k) {
    OrbitBranch& branch = found[order[k]].branch();
    branch.id = static_cast<int>(k) + 1;
    branch.component = numbers[k];
    for (SpecialPoint& special : branch.special) special.id = names.next(special.kind);
  }
  for (FoundBranch& one : found)
    if (one.origin_branch >= 0)
      one.branch().origin = found[static_cast<std::size_t>(one.origin_branch)]
                                .branch()
                                .special[one.origin_special]
                                .id;
  std::vector<OrbitBranch> branches;
  for (const std::size_t i : order) branches.push_back(std::move(found[i].branch()));
  return branches;
}

}  // namespace graze
