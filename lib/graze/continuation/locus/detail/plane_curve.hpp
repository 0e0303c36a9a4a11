// Curves in the plane of two parameters p and q, of whatever equations: a zero problem over q whose
// unknown has p/range among its entries, traced between the limits of both, with the zeros of test
// functions along it.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "graze/continuation/branch/branch_values.hpp"
#include "graze/continuation/branch/zero_problem.hpp"
#include "graze/continuation/locus/locus_values.hpp"

namespace graze {

struct PlaneCurveProblem {
  ZeroProblem problem;                 // over q
  Eigen::Index first = 0;              // where its unknown has p/range
  std::vector<UnknownRange> ranges{};  // of further unknowns, where the curve ends likewise
  // Values at `at`, a neighbour of `from` or that itself: smooth along the curve as long as `from`
  // is the same, and of a sign that does not depend on it. Nothing where there are none. Empty
  // function: nothing is looked for.
  std::function<std::optional<Vector>(const SolutionPoint& from, const SolutionPoint& at)> tests{};
  // The k-th of them alone. Empty: all are taken.
  std::function<std::optional<double>(const SolutionPoint& from, const SolutionPoint& at,
                                      Eigen::Index k)>
      test{};
  // As in ContinuationOptions.
  std::function<bool(const SolutionPoint& from, const SolutionPoint& to)> resolves{};
  // Told every new point of the curve and the one before it; false ends the curve there. Empty: go
  // on.
  std::function<bool(const SolutionPoint& previous, const SolutionPoint& here)> proceed{};
};

// Where a test passes zero.
struct TestZero {
  std::size_t test = 0;  // which of the values
  SolutionPoint point;
  std::size_t after = 0;  // lies between points after and after + 1
};

struct PlaneCurve {
  Branch branch;
  std::vector<TestZero> zeros;  // by test, of each in order along the curve
  // Of which unknown the range ended it, where one did: on the limit, or as near to it as the
  // equations can be solved where they are singular on it.
  std::array<std::optional<Eigen::Index>, 2> left_range{};
};

// Lengths of the parameters' ranges, their units in the metric of the curve; 1 where there is none.
double first_range(const LocusOptions& options);
double second_range(const LocusOptions& options);

// What the curve is traced with as a branch over the second parameter.
ContinuationOptions branch_options(const PlaneCurveProblem& problem, const LocusOptions& options);

// The point of the curve near an unknown at q, which has p/range in it: at this q, where the curve
// stands upright at this p, or near both. Nothing where none is reached in the ranges and within a
// fifth of them.
std::optional<SolutionPoint> point_on_curve(const PlaneCurveProblem& problem,
                                            const LocusOptions& options, const Vector& unknown,
                                            double second);

// The curve through a point of it, both ways.
PlaneCurve trace_curve(const PlaneCurveProblem& problem, const LocusOptions& options,
                       const SolutionPoint& start);

}  // namespace graze
