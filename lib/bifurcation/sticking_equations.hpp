// The equations of orbits that stick, those of one release (release_section.hpp), over a parameter
// of the scene: as a zero problem, and what becomes of the motion of each of their solutions.
#pragma once

#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/orbit_branch.hpp"
#include "graze/bifurcation/remembered.hpp"
#include "graze/orbit/release_section.hpp"

namespace graze {

// Remembers the system of the value asked for last, and what was followed last: one thread at a
// time.
class StickingEquations {
 public:
  // Refers to the family, which must outlive it. `reference`: see ReleaseSection.
  StickingEquations(const SystemFamily& family, const System& reference, const Release& release,
                    const PassageOptions& options)
      : StickingEquations(family, ReleaseSection(reference, release, options)) {}
  StickingEquations(const SystemFamily& family, ReleaseSection section);
  StickingEquations(const StickingEquations&) = delete;
  StickingEquations& operator=(const StickingEquations&) = delete;

  const ZeroProblem& problem() const { return problem_; }
  const ReleaseSection& section() const { return section_; }
  // The equations of the orbits of twice the period; they have the same unknowns.
  std::unique_ptr<StickingEquations> doubled() const {
    return std::make_unique<StickingEquations>(family_,
                                               section_.over(2 * section_.release().period));
  }
  // Whether the impacts are part of the equations: not where all directions are held, N = m.
  bool see_impacts() const { return section_.size() > 1; }

  // Null where the scene does not allow the value; holds until another value is asked for.
  const System* system_at(double value) const { return systems_.at(value); }
  // Forcing period there, s; requires the value to be allowed.
  double period_at(const BranchPoint& solution) const {
    return system_at(solution.parameter)->period();
  }

  // What becomes of the motion of a solution; nothing where it cannot be followed. `minima`: see
  // ReleaseSection.
  std::optional<ReleaseReturn> follow(const BranchPoint& solution, bool minima = false) const;
  // What must stay positive for its events to stay what they are, with rates along its tangent;
  // `range`: of the parameter, as in the tangent. Nothing where it cannot be followed.
  std::optional<std::vector<PassageMargin>> margins(const BranchPoint& solution,
                                                    double range) const;
  // The orbit of a solution; nothing where the motion does not return.
  std::optional<OrbitBranchPoint> judge(const BranchPoint& solution) const;

  // How far the motion is from coming back after half the period, in units of the equations; empty
  // where that is not whole.
  Vector halves_differ(const BranchPoint& solution) const;
  // Whether the branch passes an orbit of half the period between two neighbours.
  bool passes_half(const BranchPoint& a, const BranchPoint& b) const;

 private:
  std::optional<ZeroEvaluation> evaluate(const Vector& u, double value) const;

  const SystemFamily& family_;
  mutable SystemCursor systems_;
  ReleaseSection section_;
  std::optional<ReleaseSection> half_;  // of half the period
  ZeroProblem problem_;
  // By unknowns, parameter and `minima`; by unknowns and parameter.
  mutable Remembered<std::tuple<Vector, double, bool>, std::optional<ReleaseReturn>> followed_;
  mutable Remembered<std::tuple<Vector, double>, Vector> halves_;
};

// Whether a motion returns through the same events as another: the same stuck phases and, where
// they are asked for, the same impacts outside the chatters.
bool has_same_events(const ReleaseReturn& back, const ReleaseReturn& other, bool impacts);

}  // namespace graze
