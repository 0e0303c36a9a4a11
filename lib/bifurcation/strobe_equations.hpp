// The equations of orbits on compliant stops, those of the stroboscopic map (strobe_map.hpp), over
// parameters of the scene, one for a branch and two for a locus: as a zero problem, and the orbits
// of their solutions.
//
// They need first derivatives of the map, which are integrated. The slope of the last equation of a
// locus of folds, doublings or tori, for a critical multiplier, would need second ones; it is told
// by differences of the first. Newton's method ends where the equations hold, so that a solution
// does not depend on that slope, only how quickly it is reached.
//
// An orbit touches a stop at no speed where besides
//
//   b.q - a = 0,   b.q' = 0   at the forcing angle psi after the start of x_1,
//
// regular where the gap has a simple minimum there, or a simple maximum: so a contact parts in two.
#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/orbit_branch.hpp"
#include "graze/bifurcation/remembered.hpp"
#include "graze/continuation/map.hpp"
#include "graze/orbit/strobe_orbit.hpp"

namespace graze {

// How deep a solution may lie beyond a touch, in lengths of the forced motion: ten times what the
// equations are solved to.
inline constexpr double kTouchDepth = 1e-10;

// Remembers the system of the values asked for last, and the orbit judged last: one thread at a
// time.
class StrobeEquations {
 public:
  // Requires that the scene allows its own values. `units`: of the parameters, the lengths of their
  // ranges. `period`: p; `section`: see StrobeMap.
  StrobeEquations(const Scene& scene, const std::vector<std::string>& parameters,
                  std::vector<double> units, const PassageOptions& options, int period,
                  double section = 0.0);
  StrobeEquations(const StrobeEquations&) = delete;
  StrobeEquations& operator=(const StrobeEquations&) = delete;

  const ZeroProblem& problem() const { return problem_; }
  const StrobeMap& map() const { return map_; }
  int period() const { return period_; }
  double section() const { return map_.section(); }  // forcing phase, rad
  double unit(std::size_t parameter) const { return units_[parameter]; }
  // To what the test for a critical multiplier vanishes.
  static double critical_tolerance();

  // Of the forced motion at the family's own values, m, m/s.
  double length() const { return scale_.length; }
  double speed_unit() const { return scale_.speed; }
  // Null where the scene does not allow the values; holds until others are asked for.
  const System* system_at(Parameters at) const { return systems_.at(at); }
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

  // A forcing angle after the start of an orbit, as one within a turn.
  struct Place {
    Eigen::Index turn = 0;
    double angle = 0.0;  // within it, rad
  };
  Place place_of(double psi) const;
  // The equations of an orbit that touches a stop at no speed, in y = (x_1, .., x_p, first/unit,
  // psi) over the parameters behind the first one. Nothing where the motion cannot be followed, or
  // the values are not allowed.
  std::optional<ZeroEvaluation> touching(const Vector& y, Parameters behind, int stop) const;
  // b.q'' on the way there, in speeds of the forced motion per rad; nothing likewise.
  std::optional<double> push(const Vector& y, Parameters behind, int stop) const;
  // The touch there, as an orbit has it.
  std::optional<StrobeTouch> touch_at(const Vector& y, Parameters behind, int stop) const;

  // Where the section would lie farthest from all instants at which the derivative of the motion
  // jumps, as a forcing phase, rad; nothing where there are none, or where it lies at least a part
  // of that far from them as it is.
  std::optional<double> clearer_section(const BranchPoint& solution) const;
  // The solution, and its tangent, in the equations of another section; nothing where it cannot be
  // solved for there.
  std::optional<BranchPoint> carried_to(const StrobeEquations& other,
                                        const ContinuationOptions& options,
                                        const BranchPoint& solution) const;

 private:
  std::optional<MapEvaluation> evaluate(const Vector& x, Parameters at) const;
  std::optional<double> product(const Vector& x, Parameters at, const Vector& left,
                                const Vector& right) const;
  std::optional<Vector> curvature(const Vector& x, Parameters at, const Vector& left,
                                  const Vector& right) const;
  // y = (x, first/unit, psi) and the others: where all parameters are.
  std::vector<double> parameters_of(const Vector& y, Parameters behind) const;

  mutable SystemCursor systems_;
  std::vector<double> units_;
  MotionScale scale_;
  StrobeMap map_;
  int period_;
  ZeroProblem problem_;
  mutable Remembered<std::tuple<Vector, double>, std::optional<OrbitBranchPoint>> judged_;
};

}  // namespace graze
