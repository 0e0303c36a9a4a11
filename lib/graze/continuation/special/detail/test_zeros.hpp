// Where functions along a branch pass zero: the tests of a curve, or numbers of a user's own.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "graze/continuation/branch/branch_values.hpp"
#include "graze/continuation/branch/zero_problem.hpp"

namespace graze {

// Functions along a branch, smooth there.
struct BranchTests {
  // Their values at `at`, which is a neighbour of `from` or `from` itself: for a fixed `from`, with
  // signs that do not depend on it. Returns nullopt when they cannot be computed.
  std::function<std::optional<Vector>(const SolutionPoint& from, const SolutionPoint& at)> all{};
  // The k-th alone. Empty: all are computed.
  std::function<std::optional<double>(const SolutionPoint& from, const SolutionPoint& at,
                                      Eigen::Index k)>
      one{};
};

// Where a test passes zero.
struct TestZero {
  std::size_t test = 0;  // which of the tests
  SolutionPoint point;
  std::size_t after = 0;  // lies between points after and after + 1
};

// By test, for each in order along the branch. `options`: those of the branch.
std::vector<TestZero> test_zeros(const ZeroProblem& problem, const ContinuationOptions& options,
                                 const Branch& branch, const BranchTests& tests);

}  // namespace graze
