// Zero problems whose solutions are known, and how the tests trace them.
#pragma once

#include <gtest/gtest.h>

#include "graze/continuation/branch.hpp"

namespace graze::support {

struct Scalar {
  double value, by_u, by_parameter;
};

// One equation in one unknown.
template <class F>
ZeroProblem scalar_problem(F f) {
  ZeroProblem problem;
  problem.evaluate = [f](const Vector& u, Parameters parameters) -> std::optional<ZeroEvaluation> {
    const double p = parameters[0];
    const Scalar at = f(u[0], p);
    return ZeroEvaluation{Vector::Constant(1, at.value), Matrix::Constant(1, 1, at.by_u),
                          Vector::Constant(1, at.by_parameter)};
  };
  return problem;
}

// u = p: a branch to hang multipliers on.
inline ZeroProblem straight_line() {
  return scalar_problem([](double u, double p) { return Scalar{u - p, 1.0, -1.0}; });
}

inline ContinuationOptions range(double from, double to) { return {.from = from, .to = to}; }

// The branch through the solution near u at p.
inline Branch traced(const ZeroProblem& problem, const ContinuationOptions& options,
                     const Vector& u, double p) {
  const auto start = solve_at(problem, options, u, p);
  EXPECT_TRUE(start);
  return trace_branch(problem, options, start.value());
}

inline Branch traced(const ZeroProblem& problem, const ContinuationOptions& options, double u,
                     double p) {
  return traced(problem, options, Vector::Constant(1, u), p);
}

}  // namespace graze::support
