#include "graze/bifurcation/pattern_branches.hpp"

#include <algorithm>
#include <utility>

#include "graze/base/angle.hpp"

namespace graze {
namespace {

// How many impacts the canonical order begins later.
std::size_t canonical_start(const std::vector<int>& stops) {
  std::size_t best = 0;
  for (std::size_t turn = 1; turn < stops.size(); ++turn)
    for (std::size_t i = 0; i < stops.size(); ++i) {
      const int here = stops[(turn + i) % stops.size()], there = stops[(best + i) % stops.size()];
      if (here == there) continue;
      if (here < there) best = turn;
      break;
    }
  return best;
}

// The impacts from another one on, the passed ones a period later.
std::vector<ImpactPoint> turned(std::vector<ImpactPoint> impacts, std::size_t turn, int period) {
  for (std::size_t i = 0; i < turn; ++i) impacts[i].theta += kTurn * period;
  std::rotate(impacts.begin(), impacts.begin() + static_cast<std::ptrdiff_t>(turn), impacts.end());
  const double back = impacts.front().theta - wrapped(impacts.front().theta);
  for (ImpactPoint& impact : impacts) impact.theta -= back;
  return impacts;
}

}  // namespace

ImpactPattern canonical(ImpactPattern pattern) {
  std::rotate(pattern.stops.begin(),
              pattern.stops.begin() + static_cast<std::ptrdiff_t>(canonical_start(pattern.stops)),
              pattern.stops.end());
  return pattern;
}

std::vector<ImpactPoint> in_canonical_order(const ImpactPattern& pattern,
                                            std::vector<ImpactPoint> impacts) {
  return turned(std::move(impacts), canonical_start(pattern.stops), pattern.period);
}

PatternBranches::PatternBranches(const SystemFamily& family, ImpactPattern pattern,
                                 const ShootingScale& scale, ContinuationOptions range,
                                 bool keep_virtual)
    : equations_(family, std::move(pattern), scale),
      options_(std::move(range)),
      keep_virtual_(keep_virtual) {
  options_.proceed = [this](const BranchPoint& previous, const BranchPoint& here) {
    if (equations_.passes_half(previous, here)) return false;
    return lists(here);
  };
}

std::optional<BranchPoint> PatternBranches::solve(const std::vector<ImpactPoint>& impacts,
                                                  double value) const {
  if (!equations_.system_at(value)) return {};
  return solve_at(equations_.problem(), options_, equations_.shooting().pack(impacts), value);
}

bool PatternBranches::lists(const BranchPoint& solution) const {
  return keep_virtual_ || equations_.admissibility_of(solution).admissible;
}

std::vector<BranchPoint> PatternBranches::rewritten(const BranchPoint& solution) const {
  const ImpactPattern& pattern = equations_.pattern();
  const std::vector<ImpactPoint> impacts = equations_.points(solution);
  std::vector<BranchPoint> list;
  for (std::size_t turn = 0; turn < impacts.size(); ++turn) {
    std::vector<int> stops = pattern.stops;
    std::rotate(stops.begin(), stops.begin() + static_cast<std::ptrdiff_t>(turn), stops.end());
    if (stops != pattern.stops) continue;
    list.push_back(solution);
    list.back().u = equations_.shooting().pack(turned(impacts, turn, pattern.period));
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

std::vector<OrbitBranch> PatternBranches::parts(const Branch& branch) const {
  return orbit_parts(equations_, options_, branch, keep_virtual_);
}

}  // namespace graze
