// Curves in the plane of two parameters p and q, of any equations: a zero problem over q whose
// unknown has p/range among its entries, traced between the limits of both, with the zeros of test
// functions along it.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "graze/continuation/branch/branch_values.hpp"
#include "graze/continuation/branch/zero_problem.hpp"
#include "graze/continuation/locus/locus_values.hpp"
#include "graze/continuation/special/detail/test_zeros.hpp"

namespace graze {

struct PlaneCurveProblem {
  ZeroProblem problem;                 // over q
  Eigen::Index first = 0;              // where its unknown has p/range
  std::vector<UnknownRange> ranges{};  // ranges of further unknowns, at which the curve ends, too
  BranchTests tests{};                 // none where it gives none
  // As in ContinuationOptions.
  std::function<bool(const SolutionPoint& from, const SolutionPoint& to)> resolves{};
  // Called with every new point of the curve and the previous one; false ends the curve there.
  // Empty: goes on.
  std::function<bool(const SolutionPoint& previous, const SolutionPoint& here)> proceed{};
};

struct PlaneCurve {
  Branch branch;
  std::vector<TestZero> zeros;  // by test, for each in order along the curve
  // The unknown whose range ended the curve, if one did: on the limit, or as near to it as the
  // equations can be solved where they are singular on it.
  std::array<std::optional<Eigen::Index>, 2> left_range{};
};

// Lengths of the parameters' ranges, their units in the metric of the curve; 1 where they are
// empty.
double first_range(const LocusOptions& options);
double second_range(const LocusOptions& options);

// The options with which the curve is traced as a branch over the second parameter.
ContinuationOptions branch_options(const PlaneCurveProblem& problem, const LocusOptions& options);

// The point of the curve near an unknown, which contains p/range, at q: at this q; where q is
// constant along the curve, at this p; or near both. Returns nullopt when there is none in the
// ranges and within a fifth of them.
std::optional<SolutionPoint> point_on_curve(const PlaneCurveProblem& problem,
                                            const LocusOptions& options, const Vector& unknown,
                                            double second);

// The curve through a point of it, in both directions.
PlaneCurve trace_curve(const PlaneCurveProblem& problem, const LocusOptions& options,
                       const SolutionPoint& start);

}  // namespace graze
