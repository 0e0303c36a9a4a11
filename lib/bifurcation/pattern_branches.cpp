#include "graze/bifurcation/pattern_branches.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace graze {
PatternBranches::PatternBranches(const SystemFamily& family, ImpactPattern pattern,
                                 const MotionScale& scale, ContinuationOptions range,
                                 bool keep_virtual)
    : equations_(family.scene(), {family.parameter()}, std::move(pattern), scale),
      options_(std::move(range)),
      keep_virtual_(keep_virtual) {
  options_.proceed = [this](const BranchPoint& previous, const BranchPoint& here) {
    if (equations_.passes_half(previous, here)) return false;
    return lists(here);
  };
}

std::optional<BranchPoint> PatternBranches::solve(const std::vector<ImpactPoint>& impacts,
                                                  double value) const {
  if (!equations_.system_at(Parameters(&value, 1))) return {};
  return solve_at(equations_.problem(), options_, equations_.shooting().pack(impacts), value);
}

Vector PatternBranches::direction(const SpecialOrbit::Direction& along) const {
  const Vector u = equations_.shooting().pack(along.impacts);
  Vector x(u.size() + 1);
  x << u, along.value / std::abs(options_.to - options_.from);
  return x.normalized();
}

std::optional<BranchPoint> PatternBranches::solve_near(
    const std::vector<ImpactPoint>& impacts, double value,
    const std::optional<SpecialOrbit::Direction>& along) const {
  if (!equations_.system_at(Parameters(&value, 1))) return {};
  return graze::solve_near(equations_.problem(), options_, equations_.shooting().pack(impacts),
                           value, along ? direction(*along) : Vector());
}

BranchPoint PatternBranches::crossing(const std::vector<ImpactPoint>& impacts, double value,
                                      const SpecialOrbit::Direction& along) const {
  BranchPoint point;
  point.u = equations_.shooting().pack(impacts);
  point.parameter = value;
  point.tangent = direction(along);
  return point;
}

bool PatternBranches::lists(const BranchPoint& solution) const {
  return keep_virtual_ || equations_.admissibility_of(solution).admissible;
}

std::vector<BranchPoint> PatternBranches::rewritten(const BranchPoint& solution) const {
  std::vector<BranchPoint> list;
  for (const std::vector<ImpactPoint>& impacts :
       rewritings(equations_.pattern(), equations_.points(solution))) {
    list.push_back(solution);
    list.back().u = equations_.shooting().pack(impacts);
  }
  return list;
}

bool PatternBranches::knows(const BranchPoint& solution) const {
  if (traced_.empty()) return false;
  for (const BranchPoint& same : rewritten(solution))
    for (const Branch& branch : traced_)
      if (lies_on(equations_.problem(), options_, branch, same)) return true;
  return false;
}

int PatternBranches::crossings(const BranchPoint& at) const {
  int passing = 0;
  for (const BranchPoint& same : rewritten(at))
    for (const Branch& branch : traced_)
      passing += crosses_at(equations_.problem(), options_, branch, same) ? 1 : 0;
  return passing;
}

bool PatternBranches::knows_crossing(const BranchPoint& at) const { return crossings(at) >= 2; }

// A trace that ended at the doubling has a branch point there, beside which Newton's method is too
// slow to tell what lies on the trace.
bool PatternBranches::knows_doubling(const BranchPoint& at) const {
  return crossings(at) >= 1 || knows(at);
}

const Branch& PatternBranches::trace(const BranchPoint& start, Directions directions) {
  traced_.push_back(trace_branch(equations_.problem(), options_, start, directions));
  return traced_.back();
}

const Branch& PatternBranches::trace_across(const BranchPoint& crossing) {
  Branch branch = trace_branch(equations_.problem(), options_, crossing, Directions::kBoth);
  // It is among the points, and no sign changes from it to the next.
  const auto here = std::find_if(branch.points.begin(), branch.points.end(),
                                 [&](const BranchPoint& point) { return point.orientation == 0; });
  if (here != branch.points.begin() && here < branch.points.end() - 1) {
    const auto index = static_cast<std::size_t>(here - branch.points.begin());
    CriticalPoint critical{CriticalKind::kBranchPoint, *here, index - 1, {}};
    if (!here->multipliers.empty())
      critical.multiplier =
          *std::min_element(here->multipliers.begin(), here->multipliers.end(),
                            [](const Eigenvalue& a, const Eigenvalue& b) {
                              return std::abs(a.value - 1.0) < std::abs(b.value - 1.0);
                            });
    branch.points.erase(here);
    for (CriticalPoint& other : branch.critical)
      if (other.after >= index) --other.after;
    const auto after =
        std::find_if(branch.critical.begin(), branch.critical.end(),
                     [&](const CriticalPoint& other) { return other.after >= index; });
    branch.critical.insert(after, std::move(critical));
  }
  traced_.push_back(std::move(branch));
  return traced_.back();
}

std::vector<OrbitBranch> PatternBranches::parts(const Branch& branch) const {
  return orbit_parts(equations_, options_, branch, keep_virtual_);
}

}  // namespace graze
