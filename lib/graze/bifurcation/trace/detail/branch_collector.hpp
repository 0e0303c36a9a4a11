// Traces branches of orbits from given starts, and switches at their special points; stores the
// branches found, and recognises what has been traced already.
#pragma once

#include <deque>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "graze/bifurcation/trace/detail/found_branches.hpp"
#include "graze/bifurcation/trace/detail/orbit_problems.hpp"
#include "graze/bifurcation/trace/orbit_branches_values.hpp"
#include "graze/bifurcation/trace/shown_branches.hpp"
#include "graze/continuation/branch/detail/known_branch.hpp"

namespace graze {

class BranchCollector {
 public:
  // Refers to all of them; counts in `result`. Points are added until the curve of `shown` is
  // smooth; empty: branches are left as they were traced.
  BranchCollector(const SystemFamily& family, const BranchOptions& options,
                  const OrbitNumber& shown, OrbitBranches& result);

  // Traces the branch through the orbit, or through the solution near these impacts, unless it is
  // known already or not to be listed. Returns whether there is a solution.
  bool trace_from(const Orbit& orbit, double value);
  bool trace_from(const ImpactPattern& pattern, const std::vector<ImpactPoint>& impacts,
                  double value);
  // Traces the response that meets no stop, through its solution at a value.
  void trace_response(double value);
  // Traces from a special point, at the family's own value.
  void trace_from_special(const BranchStart& start);
  // Switches at the special points, in order of their depth.
  void follow();
  // The normal forms of the folds and doublings found so far.
  void add_normal_forms();

  const std::vector<FoundBranch>& found() const { return found_; }
  std::vector<FoundBranch> take() { return std::move(found_); }
  // Sentences: why orbits were not continued.
  const std::set<std::string>& notes() const { return notes_; }

 private:
  using Written = OrbitProblems::Written;
  // A special point of a found branch, or none.
  struct Origin {
    int branch = -1;
    std::size_t special = 0;
    bool at_grazing = false;
  };
  struct Traced {
    LaidOrbits* orbits;
    KnownBranch branch;
  };

  bool trace_written(const Written& start, double value, Origin origin);
  // Forms of the orbit of a restart, and the solution there; nullopt when it is not found again.
  std::vector<Written> written(const SpecialOrbit& at);
  std::optional<SolutionPoint> solution_at(const Written& written, const BranchStart& start) const;
  void trace_restarted(LaidOrbits& orbits, const SolutionPoint& point, const BranchStart& start);
  // Whether the solution lies on a branch that has been traced.
  bool knows(const LaidOrbits& orbits, const SolutionPoint& solution) const;
  // Whether the branch that leaves a special point has been traced.
  bool knows_beyond(const LaidOrbits& orbits, const SolutionPoint& start) const;
  std::vector<BranchPiece> trace(LaidOrbits& orbits, const SolutionPoint& start,
                                 Directions directions);
  // Keeps the parts of a trace.
  void add(std::vector<BranchPiece> pieces, Origin origin);
  // Whether another branch leads away from there that was not known.
  bool switch_from(const SpecialPoint& special, const SpecialContinuation& continuation,
                   Origin origin);
  bool switch_across(LaidOrbits& known, const SpecialPoint& special, Origin origin);

  const SystemFamily& family_;
  const BranchOptions& options_;
  const OrbitNumber& shown_;
  OrbitBranches& result_;
  ContinuationOptions continuation_;
  OrbitProblems problems_;
  std::deque<Traced> traced_;
  std::set<std::string> notes_;
  std::vector<FoundBranch> found_;
};

}  // namespace graze
