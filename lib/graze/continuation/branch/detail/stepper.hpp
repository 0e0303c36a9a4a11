// One step along a branch: its largest length, its prediction, and the tests that it has stayed on
// its branch.
//
// Lengths are arclength in x = (u, parameter/range). A step is refused, to be taken shorter, when
// Newton's corrections do not shrink fourfold, the tangent turns too far, the way back does not
// lead to the start of the step, the orientation changes, or a pair of folds would be passed
// unseen.
#pragma once

#include <optional>

#include "graze/continuation/branch/detail/corrector.hpp"
#include "graze/continuation/branch/detail/parameter_limits.hpp"
#include "graze/continuation/branch/detail/unknown_limits.hpp"

namespace graze {

class Stepper {
 public:
  // Refers to both, which must outlive it.
  Stepper(const ContinuationOptions& options, Corrector& corrector)
      : options_(options), limits_(options), unknowns_(options), corrector_(corrector) {}

  // The longest step that the options allow from here.
  double longest(const SolutionPoint& here) const;

  // The predicted end x of a step of length h: along the tangent, and along the curvature of the
  // cubic through the last two points and their tangents. `before`: the previous point; null where
  // there is none.
  Vector prediction(const SolutionPoint* before, const SolutionPoint& here, double h) const;

  // Whether the way back from the end of a step must lead to its start. From a branch point
  // Newton's method may lead back onto the other branch, however short the step.
  enum class WayBack { kJudged, kLeftOut };

  // The end of a step of length h, on a limit where it would pass one; nullopt when the step is
  // refused. A branch point may be passed by a step of at most the length `passing`. Sets `turn` to
  // the angle between the tangents, rad, as soon as the corrector converges.
  std::optional<SolutionPoint> step(const SolutionPoint* before, const SolutionPoint& here,
                                    double h, double& turn, double passing = 0.0,
                                    WayBack way_back = WayBack::kJudged);

 private:
  std::optional<SolutionPoint> point_ahead(const SolutionPoint* before, const SolutionPoint& here,
                                           double h);
  Vector bend(const SolutionPoint* before, const SolutionPoint& here, double h) const;
  bool leads_back(const Vector& x, const SolutionPoint& next, const Vector& chord);

  const ContinuationOptions& options_;
  ParameterLimits limits_;
  UnknownLimits unknowns_;
  Corrector& corrector_;
};

}  // namespace graze
