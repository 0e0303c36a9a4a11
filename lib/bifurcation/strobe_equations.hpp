// The equations of orbits on compliant stops, those of the stroboscopic map (strobe_map.hpp), over
// a parameter of the scene: as a zero problem, and the orbits of their solutions.
#pragma once

#include <optional>
#include <tuple>

#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/orbit_branch.hpp"
#include "graze/bifurcation/remembered.hpp"
#include "graze/continuation/map.hpp"
#include "graze/orbit/strobe_orbit.hpp"

namespace graze {

// Remembers the system of the value asked for last, and the orbit judged last: one thread at a
// time.
class StrobeEquations {
 public:
  // Refers to the family, which must outlive it. `period`: p.
  StrobeEquations(const SystemFamily& family, const StrobeOptions& options, int period);
  StrobeEquations(const StrobeEquations&) = delete;
  StrobeEquations& operator=(const StrobeEquations&) = delete;

  const ZeroProblem& problem() const { return problem_; }
  const StrobeMap& map() const { return map_; }
  int period() const { return period_; }

  // Of the forced motion at the family's own value, m.
  double length() const { return length_; }
  // Of the forcing there, rad/s; requires the value to be allowed.
  double frequency_at(const BranchPoint& solution) const {
    return systems_.at(solution.parameter)->forcing->frequency;
  }
  // How far the second half of a solution is from the first, in units of the map; empty where the
  // period is odd.
  Vector halves_differ(const BranchPoint& solution) const;
  // Whether it has half the period.
  bool is_half(const BranchPoint& solution) const;
  // Whether the branch passes an orbit of half the period between two neighbours.
  bool passes_half(const BranchPoint& a, const BranchPoint& b) const;
  // The orbit of a solution; nothing where the motion cannot be followed or meets no stop.
  std::optional<OrbitBranchPoint> judge(const BranchPoint& solution) const;

 private:
  std::optional<MapEvaluation> evaluate(const Vector& x, double value) const;

  mutable SystemCursor systems_;
  StrobeMap map_;
  double length_;
  int period_;
  ZeroProblem problem_;
  mutable Remembered<std::tuple<Vector, double>, std::optional<OrbitBranchPoint>> judged_;
};

}  // namespace graze
