// What is kept of a branch that is stopped before its end.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "graze/continuation/map.hpp"

namespace graze {
namespace {

// x -> p x (1 - x): its fixed point 1 - 1/p doubles at p = 3, and a 2-cycle at 1 + sqrt(6).
ZeroProblem logistic_map(int period) {
  return periodic_points(
      {[](const Vector& x, Parameters parameters) -> std::optional<MapEvaluation> {
        const double p = parameters[0];
        return MapEvaluation{Vector::Constant(1, p * x[0] * (1.0 - x[0])),
                             Matrix::Constant(1, 1, p * (1.0 - 2.0 * x[0])),
                             Vector::Constant(1, x[0] * (1.0 - x[0]))};
      }},
      period);
}

// Interrupted as soon as it is beyond a value.
Branch traced_beyond(int period, const Vector& u, double start, double value) {
  std::atomic<bool> interrupted = false;
  const ZeroProblem problem = logistic_map(period);
  ContinuationOptions options;
  options.from = 2.0;
  options.to = 4.0;
  options.stop.interrupted = &interrupted;
  options.proceed = [&](const SolutionPoint&, const SolutionPoint& here) {
    if (here.parameter > value) interrupted = true;
    return true;
  };
  const std::optional<SolutionPoint> at = solve_at(problem, options, u, start);
  return at ? trace_branch(problem, options, *at, Directions::kForward) : Branch{};
}

TEST(StoppedBranches, AreKeptWithTheirSpecialPoints) {
  const Branch fixed = traced_beyond(1, Vector::Constant(1, 0.5), 2.0, 3.2);
  EXPECT_EQ(fixed.ends[1], BranchEnd::kStopped);
  ASSERT_EQ(fixed.critical_of(CriticalKind::kPeriodDoubling).size(), 1u);
  EXPECT_NEAR(fixed.critical_of(CriticalKind::kPeriodDoubling)[0].point.parameter, 3.0, 1e-11);
  // The 2-cycle: x = (p + 1 -+ sqrt((p + 1)(p - 3)))/(2 p).
  const double p = 3.2, root = std::sqrt((p + 1.0) * (p - 3.0));
  const Branch cycle = traced_beyond(
      2, Vector{{(p + 1.0 - root) / (2.0 * p), (p + 1.0 + root) / (2.0 * p)}}, p, 3.6);
  ASSERT_EQ(cycle.critical_of(CriticalKind::kPeriodDoubling).size(), 1u);
  EXPECT_NEAR(cycle.critical_of(CriticalKind::kPeriodDoubling)[0].point.parameter,
              1.0 + std::sqrt(6.0), 1e-11);
}

}  // namespace
}  // namespace graze
