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
  double section() const { return map_.options().section; }  // forcing phase, rad

  // Of the forced motion at the family's own value, m.
  double length() const { return length_; }
  // Of the forcing there, rad/s; requires the value to be allowed.
  double frequency_at(const BranchPoint& solution) const {
    return systems_.at(solution.parameter)->forcing()->frequency;
  }
  // Speed of the forced motion there, m/s; requires likewise.
  double speed_unit(const BranchPoint& solution) const { return length_ * frequency_at(solution); }
  // How far the second half of a solution is from the first, in units of the map; empty where the
  // period is odd.
  Vector halves_differ(const BranchPoint& solution) const;
  // Whether it has half the period.
  bool is_half(const BranchPoint& solution) const;
  // Whether the branch passes an orbit of half the period between two neighbours.
  bool passes_half(const BranchPoint& a, const BranchPoint& b) const;
  // The orbit of a solution; nothing where the motion cannot be followed or meets no stop.
  std::optional<OrbitBranchPoint> judge(const BranchPoint& solution) const;
  // The orbit of a solution that has this touch, and the one without it: nothing happens there.
  // Nothing likewise, and in place of an orbit that meets no stop but by the touch.
  std::optional<OrbitBranchPoint> judge_touching(const BranchPoint& solution,
                                                 const StrobeTouch& touch) const;
  std::optional<OrbitBranchPoint> judge_without(const BranchPoint& solution,
                                                const StrobeTouch& touch) const;
  // The stops that its contacts are with, in order of their numbers; none where it meets none.
  std::vector<int> stops_met(const BranchPoint& solution) const;
  // As touches_near() of strobe_orbit.hpp.
  std::vector<StrobeTouch> touches_near(const BranchPoint& solution) const;
  // Whether the force of a stop sets in without a jump there: else the branch has a corner where a
  // contact is born.
  bool sets_in_smoothly(const BranchPoint& solution, int stop) const;

  // How far the motion from a state is beyond a stop at a forcing angle after it, in lengths of the
  // forced motion, and how fast it goes on, in its speeds.
  struct Touching {
    Eigen::Vector2d value, by_parameter, by_angle;
    Matrix by_state;    // 2 x 2N
    double push = 0.0;  // the rate of the speed by the angle
  };
  // Where the section would lie farthest from all instants at which the derivative of the motion
  // jumps, as a forcing phase, rad; nothing where there are none, or where it lies at least a part
  // of that far from them as it is.
  std::optional<double> clearer_section(const BranchPoint& solution) const;
  // The solution, and its tangent, in the equations of another section; nothing where it cannot be
  // solved for there.
  std::optional<BranchPoint> carried_to(const StrobeEquations& other,
                                        const ContinuationOptions& options,
                                        const BranchPoint& solution) const;

  // Nothing where the motion cannot be followed, or the value is not allowed.
  std::optional<Touching> touching(const Vector& x, double value, double angle, int stop) const;

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
