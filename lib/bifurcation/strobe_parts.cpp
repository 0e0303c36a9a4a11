#include "graze/bifurcation/strobe_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace graze {
namespace {

class Parting {
 public:
  Parting(const StrobeEquations& equations, const ContinuationOptions& options, const Branch& trace)
      : equations_(equations), options_(options), trace_(trace) {}

  std::vector<StrobePart> cut() {
    begin(as_orbit_end(trace_.ends[0]));
    auto critical = trace_.critical.begin();
    for (std::size_t i = 0; i < trace_.points.size(); ++i) {
      add(trace_.points[i]);
      if (i + 1 == trace_.points.size()) break;
      const BranchPoint* last = &trace_.points[i];
      for (; critical != trace_.critical.end() && critical->after == i; ++critical) {
        pass(*last, critical->point);
        add_critical(*critical);
        last = &critical->point;
      }
      pass(*last, trace_.points[i + 1]);
    }
    close(as_orbit_end(trace_.ends[1]));
    std::erase_if(parts_, [](const StrobePart& part) { return part.branch.points.empty(); });
    return std::move(parts_);
  }

 private:
  void begin(OrbitBranchEnd end) {
    parts_.emplace_back();
    parts_.back().branch.ends = {end, end};
    parts_.back().branch.pattern.period = equations_.period();
  }
  void close(OrbitBranchEnd end) { parts_.back().branch.ends[1] = end; }

  std::vector<int> stops_of(const BranchPoint& point) const {
    const std::optional<OrbitBranchPoint> at = equations_.judge(point);
    return at ? at->orbit.pattern().stops : std::vector<int>();
  }

  void add(const BranchPoint& point) {
    const std::optional<OrbitBranchPoint> at = equations_.judge(point);
    if (!at) return;
    OrbitBranch& part = parts_.back().branch;
    if (part.points.empty()) part.pattern = at->orbit.pattern();
    part.points.push_back(*at);
  }

  void add_critical(const CriticalPoint& critical) {
    const std::optional<OrbitBranchPoint> at = equations_.judge(critical.point);
    if (!at || !is_of_orbits(critical)) return;
    add(critical.point);
    StrobePart& part = parts_.back();
    part.branch.special.push_back(as_special(critical, *at));
    part.critical.push_back(critical);
  }

  // The grazings between neighbours: nothing but how many contacts there are tells them.
  void pass(const BranchPoint& a, const BranchPoint& b) {
    const std::vector<int> before = stops_of(a), after = stops_of(b);
    if (before.size() == after.size()) return;
    const std::optional<BranchPoint> at = grazing_between(a, b, before.size(), after.size());
    if (at) add_grazing(*at, before.size() < after.size());
    close(OrbitBranchEnd::kGrazing);
    begin(OrbitBranchEnd::kGrazing);
    if (at) add_grazing(*at, before.size() > after.size());
    parts_.back().branch.pattern.stops = after;
  }

  // `approach`: an approach touches there, else a contact loses its speed.
  void add_grazing(const BranchPoint& at, bool approach) {
    const std::optional<OrbitBranchPoint> orbit = equations_.judge(at);
    if (!orbit) return;
    StrobePart& part = parts_.back();
    part.branch.points.push_back(*orbit);
    part.branch.special.push_back({SpecialKind::kGrazing, "", *orbit, {}, !approach, at});
    part.critical.emplace_back();
  }

  // The gap of an approach falls through zero in proportion to the distance; beyond, the square of
  // the speed of the contact grows with it.
  std::optional<BranchPoint> grazing_between(const BranchPoint& a, const BranchPoint& b,
                                             std::size_t before, std::size_t after) const {
    const std::size_t fewer = std::min(before, after);
    const double sign = before < after ? 1.0 : -1.0;
    const auto test = [&](const BranchPoint& point) {
      const std::optional<OrbitBranchPoint> at = equations_.judge(point);
      const std::size_t here = at ? at->orbit.impacts.size() : 0;
      if (here > fewer) return -sign * at->smallest_speed * at->smallest_speed;
      return sign * (at && at->orbit.clearance ? std::abs(*at->orbit.clearance) : 1.0);
    };
    return locate(equations_.problem(), options_, a, b, test);
  }

  const StrobeEquations& equations_;
  const ContinuationOptions& options_;
  const Branch& trace_;
  std::vector<StrobePart> parts_;
};

}  // namespace

std::vector<StrobePart> parts_of(const StrobeEquations& equations,
                                 const ContinuationOptions& options, const Branch& trace) {
  return Parting(equations, options, trace).cut();
}

}  // namespace graze
