// Traces branches of orbits from starts, whoever offers them, and switches at their special points;
// keeps what was found, and knows what has been traced already.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/found_branches.hpp"
#include "graze/bifurcation/orbit_branches_values.hpp"
#include "graze/bifurcation/sticking_branches.hpp"

namespace graze {

class BranchCollector {
 public:
  // Refers to all of them; counts in `result`.
  BranchCollector(const SystemFamily& family, const BranchOptions& options, OrbitBranches& result);

  // Traces the branch through the solution near these impacts, unless it is known already or is
  // none. Whether there is a solution.
  bool trace_from(const ImpactPattern& pattern, const std::vector<ImpactPoint>& impacts,
                  double value);
  // Traces the branch of an orbit that sticks unless it is known, and with `follow_depth` those
  // beyond its ends.
  void trace_from_sticking(const Orbit& orbit, double value);
  // From a special point, at the family's own value.
  void trace_from_special(const BranchStart& start);
  // Switches at the special points, those of one depth after the other.
  void follow();

  const std::vector<FoundBranch>& found() const { return found_; }
  std::vector<FoundBranch> take() { return std::move(found_); }
  // Sentences: why orbits that stick were not continued.
  const std::set<std::string>& sticking_notes() const { return sticking_notes_; }

 private:
  PatternBranches& pattern_branches(const ImpactPattern& pattern);
  void trace_from_section(const SpecialOrbit::Followed& section);
  void trace_from_impacts(const BranchStart& start);
  // What is traced or switched from at a special point.
  std::optional<BranchPoint> solution_at(const PatternBranches& branches,
                                         const std::vector<ImpactPoint>& impacts,
                                         const BranchStart& start) const;
  // The origin of a branch: a special point, where there is one.
  void add_sticking(const Orbit& orbit, double value, int depth, int origin_branch,
                    std::size_t origin_special);
  void add_trace(PatternBranches& branches, const BranchPoint& start, Directions directions,
                 int origin_branch, std::size_t origin_special);
  // Keeps the parts of a trace.
  void add_parts(PatternBranches& branches, const Branch& branch, Directions directions,
                 int origin_branch, std::size_t origin_special);
  void switch_at(std::size_t index, std::size_t which);
  void switch_from(const OrbitEquations& known, const SpecialPoint& special, int origin_branch,
                   std::size_t origin_special);

  const SystemFamily& family_;
  const BranchOptions& options_;
  OrbitBranches& result_;
  ContinuationOptions continuation_;
  std::map<std::pair<int, std::vector<int>>, std::unique_ptr<PatternBranches>> patterns_;
  StickingBranches sticking_;
  std::set<std::string> sticking_notes_;
  std::vector<FoundBranch> found_;
};

}  // namespace graze
