// A traced branch, prepared for many tests whether solutions lie on it.
//
// A solution between two neighbours is no further from their chord than half of `max_turn` times
// its length (lies_between of locate.hpp). Boxes around runs of points, wider by that much,
// therefore exclude most solutions. Periodic unknowns are not compared with boxes.
#pragma once

#include <vector>

#include "graze/continuation/branch/branch_values.hpp"
#include "graze/continuation/branch/detail/corrector.hpp"

namespace graze {

class KnownBranch {
 public:
  // `points`: of a branch of the corrector's equations and options, in order. `wrap`: of those
  // equations.
  KnownBranch(const Corrector& corrector, std::vector<SolutionPoint> points, const Vector& wrap,
              double max_turn);

  // Whether a solution of the same equations lies on it.
  bool has(Corrector& corrector, const SolutionPoint& point) const;

 private:
  struct Box {
    Vector low, high;  // of x; what comes round is anywhere
    void add(const Vector& x, double margin);
    bool contains(const Vector& x) const;
  };

  std::vector<SolutionPoint> points_;
  Vector wrap_;
  double max_turn_;
  Box whole_;
  std::vector<Box> runs_;  // of kRun segments each
};

}  // namespace graze
