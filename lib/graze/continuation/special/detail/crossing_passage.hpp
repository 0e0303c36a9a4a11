// On beyond a branch point from beside which no step leads on.
//
// Points next to a branch point are badly determined along the branch that crosses. Where a trace
// got stuck on one of them it is taken back a little, and on in one step of about the length by
// which it was taken back.
#pragma once

#include <optional>

#include "graze/continuation/branch/detail/growing_branch.hpp"
#include "graze/continuation/branch/detail/stepper.hpp"

namespace graze {

class CrossingPassage {
 public:
  // Refers to both, which must outlive it.
  CrossingPassage(Corrector& corrector, Stepper& stepper)
      : corrector_(corrector), stepper_(stepper) {}

  // The point beyond, the points too near to the branch point dropped from the branch; `h` becomes
  // the length of the step. Nothing, and the branch as it was, where that does not help either.
  std::optional<SolutionPoint> pass(GrowingBranch& branch, double& h);

 private:
  std::optional<SolutionPoint> pass_within(GrowingBranch& branch, double reach);

  Corrector& corrector_;
  Stepper& stepper_;
  std::optional<Vector> stuck_;  // where no step led on last time
  double reach_ = 0.0;           // and how far the passage was from there
};

}  // namespace graze
