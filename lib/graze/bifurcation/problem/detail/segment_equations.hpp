// The equations of orbits that are followed from section to section (segment_shooting.hpp), over
// parameters of the scene, one for a branch and two for a locus: as a zero problem, and the orbits
// of their solutions.
//
// They need first derivatives of the segments, which are carried along. The slope of the last
// equation of a locus of folds, doublings or tori, for a critical multiplier, would need second
// derivatives; it is computed by differences of the first. Newton's method ends where the equations
// hold, so that this slope does not affect a solution, only how quickly it is reached.
//
// An orbit touches a stop at zero speed where in addition
//
//   b.q - a = 0,   b.q' = 0   at the forcing angle psi after the start of x_1,
//
// which is regular where the gap has a simple minimum there, or a simple maximum, at which a
// contact splits in two. For sections at a release psi is a forcing phase, and the motion is that
// without the impact that the grazing contact of a rigid stop would be, so that it is smooth across
// the grazing.
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
// the tolerance of the equations.
inline constexpr double kGrazingDepth = 1e-10;

// Caches the system of the latest values, and the motions last followed and judged: for one thread
// at a time.
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
  // Whether the equations contain the impacts: not where all directions are held, N = m.
  bool see_impacts() const { return map().size() > 0; }
  // Tolerance of the test for a critical multiplier.
  static double critical_tolerance();

  // Units of the forced motion of the reference, m, m/s.
  double length() const { return scale_.length; }
  double speed_unit() const { return scale_.speed; }
  // Forcing period of a solution, s; requires an allowed value.
  double period_at(const SolutionPoint& solution) const {
    return system_at(solution.parameter)->period();
  }

  // Returns nullopt when the motion cannot be followed, meets no stop, or does not return to its
  // release.
  std::optional<OrbitBranchPoint> judge(const SolutionPoint& solution) const override;
  void name(OrbitBranch& branch) const override;
  std::string why_not_continued(const SolutionPoint& solution) const override;
  // Where the halves are no unknowns: the distance of the motion from repeating after half the
  // period.
  Vector halves_differ(const SolutionPoint& solution) const override;
  // The problem of another layout with the same stops closed, in the same coordinates.
  std::unique_ptr<OrbitProblem> laid(SegmentLayout layout) const;
  // On the same section where a stop is released at it; there is only one then.
  std::unique_ptr<OrbitProblem> doubled() const override;
  SolutionPoint twice_round(const SolutionPoint& solution) const override;
  std::unique_ptr<OrbitProblem> clearer(const SolutionPoint& solution) const override;
  // The same on stroboscopic sections farther from the beginnings and ends of all contacts of the
  // orbit u, at which second derivatives jump even where first ones do not; null where they are far
  // enough.
  std::unique_ptr<OrbitProblem> clear_of_contacts(const Vector& u, Parameters at) const;
  // The orbit u solved on sections at the phase theta; nullopt when it cannot be followed.
  std::optional<Vector> carried(const Vector& u, Parameters at, double theta) const;
  std::vector<SolutionPoint> rewritings(const OrbitProblem& of, const ContinuationOptions& options,
                                        const SolutionPoint& solution) const override;

  // At a release: the return of a solution's motion; nullopt when it cannot be followed. `minima`:
  // as in SegmentOptions.
  std::optional<ReleaseReturn> follow(const SolutionPoint& solution, bool minima = false) const;
  // Quantities that must stay positive for the events to stay the same, with rates along its
  // tangent; `range`: of the parameter, as in the tangent. Returns nullopt when it cannot be
  // followed.
  std::optional<std::vector<SegmentMargin>> margins(const SolutionPoint& solution,
                                                    double range) const;

  // The orbit of a solution with this touch as a contact, and without it. Returns nullopt as
  // judge() does, and for an orbit whose only contact would be the grazing one.
  std::optional<OrbitBranchPoint> judge_grazing(const SolutionPoint& solution,
                                                const GrazingContact& grazing) const;
  std::optional<OrbitBranchPoint> judge_without(const SolutionPoint& solution,
                                                const GrazingContact& grazing) const;
  // The stops of its contacts, in order of their numbers; empty where it meets none.
  std::vector<int> stops_met(const SolutionPoint& solution) const;
  // As grazing_contacts_near() of grazing_contact.hpp, on compliant stops.
  std::vector<GrazingContact> grazing_contacts_near(const SolutionPoint& solution) const;
  // Whether the force of a stop sets in without a jump there: else the branch has a corner where a
  // contact is born.
  bool sets_in_smoothly(const SolutionPoint& solution, int stop) const;

  // A forcing angle after the start of an orbit, as one within a forcing period.
  struct Place {
    Eigen::Index turn = 0;
    double angle = 0.0;  // within it, rad
  };
  // The place of y, which is the unknown of grazing().
  Place place_of(const Vector& y) const;
  // psi of a grazing contact of the orbit u.
  double psi_of(const Vector& u, const GrazingContact& grazing) const;
  // The motions of y without the impact that the grazing contact would be (grazing_contact.hpp),
  // over all parameters.
  std::optional<SegmentShooting> without_grazing(const Vector& y, Parameters all, int stop) const;
  // The equations of an orbit that touches a stop at zero speed, in y = (u, first/unit, psi) over
  // the parameters after the first one. Returns nullopt when the motion cannot be followed, or the
  // values are not allowed.
  std::optional<ZeroEvaluation> grazing(const Vector& y, Parameters behind, int stop) const;
  // b.q'' at the touch, in speeds of the forced motion per rad; nullopt likewise.
  std::optional<double> push(const Vector& y, Parameters behind, int stop) const;
  // The touch as a grazing contact of the orbit.
  std::optional<GrazingContact> grazing_at(const Vector& y, Parameters behind, int stop) const;

  std::optional<SolutionPoint> carried_to(const OrbitProblem& other,
                                          const ContinuationOptions& options,
                                          const SolutionPoint& solution) const override;

 private:
  // The phase, rad, at which a stroboscopic section is farthest from all instants at which the
  // derivative of the motion jumps; nullopt when there are none, or when the present section is at
  // least a part of that far from them.
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
  // The rate of the products of a section by unknown j, or by parameter j - n; nullopt when the
  // motion cannot be followed, or a contact is born there or passes the section.
  std::optional<ComplexVector> products_rate(const Vector& u, Parameters at, Eigen::Index j,
                                             int section,
                                             const std::vector<SegmentProduct>& list) const;
  // The values of all parameters, from y = (x, first/unit, psi) and the others.
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
  // Cached by unknowns, parameter and `minima`; by unknowns and parameter.
  mutable Remembered<std::tuple<Vector, double, bool>, std::optional<ReleaseReturn>> followed_;
  mutable Remembered<std::tuple<Vector, double>, Vector> halves_;
};

// Whether a motion returns through the same events as another: the same stuck phases and, with
// `impacts`, the same impacts outside the chatters.
bool has_same_events(const ReleaseReturn& back, const ReleaseReturn& other, bool impacts);

}  // namespace graze
