// The equations of orbits that are followed from section to section (segment_shooting.hpp), over
// parameters of the scene, one for a branch and two for a locus: as a zero problem, and the orbits
// of their solutions.
//
// They need first derivatives of the segments, which are carried along. The slope of the last
// equation of a locus of folds, doublings or tori, for a critical multiplier, would need second
// ones; it is told by differences of the first. Newton's method ends where the equations hold, so
// that a solution does not depend on that slope, only how quickly it is reached.
//
// An orbit touches a stop at no speed where besides
//
//   b.q - a = 0,   b.q' = 0   at the forcing angle psi after the start of x_1,
//
// regular where the gap has a simple minimum there, or a simple maximum: so a contact parts in two.
// Of orbits on sections at a release psi is a forcing phase, and the motion is that without the
// impact that the grazing contact of a rigid stop would be: it does not feel on which side it is.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "graze/bifurcation/problem/detail/orbit_problem.hpp"
#include "graze/bifurcation/problem/detail/remembered.hpp"
#include "graze/orbit/problem/detail/followed_orbit.hpp"
#include "graze/orbit/problem/detail/release.hpp"

namespace graze {

// How deep a solution may lie beyond a grazing contact, in lengths of the forced motion: ten times
// what the equations are solved to.
inline constexpr double kGrazingDepth = 1e-10;

// Remembers the system of the values asked for last, and what was followed and judged last: one
// thread at a time.
class SegmentEquations : public OrbitProblem {
 public:
  // Refers to the scene. `units`: of the parameters, the lengths of their ranges. `reference`: see
  // SectionMap.
  SegmentEquations(const Scene& scene, const std::vector<std::string>& parameters,
                   std::vector<double> units, const System& reference, const SegmentLayout& layout,
                   const SegmentOptions& options);

  const SegmentShooting& shooting() const { return shooting_; }
  const SectionMap& map() const { return shooting_.map(); }
  const SegmentLayout& layout() const { return shooting_.layout(); }
  OrbitLayout orbit_layout() const override { return layout(); }
  int period() const override { return layout().period; }
  bool has_multipliers() const override { return see_impacts(); }
  double unit(std::size_t parameter) const { return units_[parameter]; }
  // Whether the impacts are part of the equations: not where all directions are held, N = m.
  bool see_impacts() const { return map().size() > 0; }
  // To what the test for a critical multiplier vanishes.
  static double critical_tolerance();

  // Of the forced motion of the reference, m, m/s.
  double length() const { return scale_.length; }
  double speed_unit() const { return scale_.speed; }
  // Forcing period there, s; requires the value to be allowed.
  double period_at(const SolutionPoint& solution) const {
    return system_at(solution.parameter)->period();
  }

  // Nothing where the motion cannot be followed, meets no stop, or does not return to its release.
  std::optional<OrbitBranchPoint> judge(const SolutionPoint& solution) const override;
  void name(OrbitBranch& branch) const override;
  std::string why_not_continued(const SolutionPoint& solution) const override;
  // Where the halves are no unknowns: how far the motion is from coming back after half the period.
  Vector halves_differ(const SolutionPoint& solution) const override;
  // Of orbits of another layout with the same stops closed, in the same coordinates.
  std::unique_ptr<OrbitProblem> laid(SegmentLayout layout) const;
  // Where a stop is released at the section, which is the only one then, on that.
  std::unique_ptr<OrbitProblem> doubled() const override;
  SolutionPoint twice_round(const SolutionPoint& solution) const override;
  std::unique_ptr<OrbitProblem> clearer(const SolutionPoint& solution) const override;
  // The same on stroboscopic sections farther from the beginnings and ends of all contacts of the
  // orbit u, at which second derivatives jump where first ones do not; null where they are far
  // enough.
  std::unique_ptr<OrbitProblem> clear_of_contacts(const Vector& u, Parameters at) const;
  // The orbit u as solved on sections at the phase theta; nothing where it cannot be followed.
  std::optional<Vector> carried(const Vector& u, Parameters at, double theta) const;
  std::vector<SolutionPoint> rewritings(const OrbitProblem& of, const ContinuationOptions& options,
                                        const SolutionPoint& solution) const override;

  // At a release: what becomes of the motion of a solution; nothing where it cannot be followed.
  // `minima`: as in SegmentOptions.
  std::optional<ReleaseReturn> follow(const SolutionPoint& solution, bool minima = false) const;
  // What must stay positive for the events to stay what they are, with rates along its tangent;
  // `range`: of the parameter, as in the tangent. Nothing where it cannot be followed.
  std::optional<std::vector<SegmentMargin>> margins(const SolutionPoint& solution,
                                                    double range) const;

  // The orbit of a solution that has this touch, and the one without it: nothing happens there.
  // Nothing as judge(), and in place of an orbit that meets no stop but by the grazing contact.
  std::optional<OrbitBranchPoint> judge_grazing(const SolutionPoint& solution,
                                                const GrazingContact& grazing) const;
  std::optional<OrbitBranchPoint> judge_without(const SolutionPoint& solution,
                                                const GrazingContact& grazing) const;
  // The stops that its contacts are with, in order of their numbers; none where it meets none.
  std::vector<int> stops_met(const SolutionPoint& solution) const;
  // As grazing_contacts_near() of grazing_contact.hpp, on compliant stops.
  std::vector<GrazingContact> grazing_contacts_near(const SolutionPoint& solution) const;
  // Whether the force of a stop sets in without a jump there: else the branch has a corner where a
  // contact is born.
  bool sets_in_smoothly(const SolutionPoint& solution, int stop) const;

  // A forcing angle after the start of an orbit, as one within a turn.
  struct Place {
    Eigen::Index turn = 0;
    double angle = 0.0;  // within it, rad
  };
  // Of y as grazing() has it.
  Place place_of(const Vector& y) const;
  // psi of a grazing contact of the orbit u.
  double psi_of(const Vector& u, const GrazingContact& grazing) const;
  // The motions of y without the impact that the grazing contact would be (grazing_contact.hpp),
  // over all parameters.
  std::optional<SegmentShooting> without_grazing(const Vector& y, Parameters all, int stop) const;
  // The equations of an orbit that touches a stop at no speed, in y = (u, first/unit, psi) over the
  // parameters behind the first one. Nothing where the motion cannot be followed, or the values are
  // not allowed.
  std::optional<ZeroEvaluation> grazing(const Vector& y, Parameters behind, int stop) const;
  // b.q'' on the way there, in speeds of the forced motion per rad; nothing likewise.
  std::optional<double> push(const Vector& y, Parameters behind, int stop) const;
  // The touch there, as an orbit has it.
  std::optional<GrazingContact> grazing_at(const Vector& y, Parameters behind, int stop) const;

  std::optional<SolutionPoint> carried_to(const OrbitProblem& other,
                                          const ContinuationOptions& options,
                                          const SolutionPoint& solution) const override;

 private:
  // Where a stroboscopic section would lie farthest from all instants at which the derivative of
  // the motion jumps, as a forcing phase, rad; nothing where there are none, or where it lies at
  // least a part of that far from them as it is.
  std::optional<double> clearer_section(const SolutionPoint& solution) const;
  std::unique_ptr<OrbitProblem> at_section(double theta) const;
  SegmentEquations(const Scene& scene, const std::vector<std::string>& parameters,
                   std::vector<double> units, const MotionScale& scale, SegmentShooting shooting);
  std::optional<ShootingLinearisation> linearise(
      const System& system, const Vector& u,
      std::span<const System* const> tangents) const override;
  std::vector<Eigenvalue> multipliers(const System& system, const Vector& u,
                                      ErrorBounds errors) const override;
  std::optional<Eigen::MatrixXcd> curvature(
      const Vector& u, Parameters at, const std::vector<CriticalProduct>& products) const override;
  // The rate of the products of a section by unknown j, or by parameter j - n; nothing where the
  // motion cannot be followed, or a contact is born there or passes the section.
  std::optional<ComplexVector> products_rate(const Vector& u, Parameters at, Eigen::Index j,
                                             int section,
                                             const std::vector<SegmentProduct>& list) const;
  // y = (x, first/unit, psi) and the others: where all parameters are.
  std::vector<double> parameters_of(const Vector& y, Parameters behind) const;
  std::optional<SectionMap::Within> within(const SegmentShooting& shooting, const Vector& y,
                                           const System& system,
                                           std::span<const System* const> tangents) const;

  const Scene& scene_;
  std::vector<std::string> parameters_;
  std::vector<double> units_;
  MotionScale scale_;
  SegmentShooting shooting_;
  mutable Remembered<std::tuple<Vector, double>, std::optional<OrbitBranchPoint>> judged_;
  // By unknowns, parameter and `minima`; by unknowns and parameter.
  mutable Remembered<std::tuple<Vector, double, bool>, std::optional<ReleaseReturn>> followed_;
  mutable Remembered<std::tuple<Vector, double>, Vector> halves_;
};

// Whether a motion returns through the same events as another: the same stuck phases and, where
// they are asked for, the same impacts outside the chatters.
bool has_same_events(const ReleaseReturn& back, const ReleaseReturn& other, bool impacts);

}  // namespace graze
