// A branch as it is traced, in one direction from its start: points are added with the folds before
// them, until it meets a limit, of the parameter or of an unknown, or its own start.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "graze/continuation/branch/detail/corrector.hpp"
#include "graze/continuation/branch/detail/parameter_limits.hpp"
#include "graze/continuation/branch/detail/unknown_limits.hpp"

namespace graze {

class GrowingBranch {
 public:
  // Refers to the first three, which must outlive it. The branch follows the tangent of `start`.
  GrowingBranch(const ZeroProblem& problem, const ContinuationOptions& options,
                Corrector& corrector, SolutionPoint start);

  std::size_t size() const { return branch_.points.size(); }
  const SolutionPoint& operator[](std::size_t i) const { return branch_.points[i]; }
  const SolutionPoint& last() const { return branch_.points.back(); }
  // The point before the last; null where there is none yet.
  const SolutionPoint* before_last() const {
    return size() > 1 ? &branch_.points[size() - 2] : nullptr;
  }

  // Adds the end of a step, or what comes before it: the limit, the start of a closed branch. True
  // when that ends the branch.
  bool advance(const SolutionPoint& next);
  // Adds a point and the fold before it, if there is one.
  void add(const SolutionPoint& next);
  // Drops all points but the first `count`.
  void keep(std::size_t count);
  void count_rejected() { ++branch_.rejected; }

  // The branch, once it has ended; moves it out.
  Branch take() { return std::move(branch_); }
  void end(BranchEnd end) { branch_.ends[1] = end; }

 private:
  bool closes(const SolutionPoint& next);
  bool crosses_start(const SolutionPoint& next);
  SolutionPoint closing_point() const;

  const ZeroProblem& problem_;
  const ContinuationOptions& options_;
  ParameterLimits limits_;
  UnknownLimits unknowns_;
  Corrector& corrector_;
  Branch branch_;
  bool left_start_ = false;  // it has been so far from the start that it may come back
};

// One branch from two that lead away from a common start, backwards along the first.
Branch joined(const Branch& backward, const Branch& forward);

}  // namespace graze
