#include "graze/continuation/branch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/continuation/branch/detail/growing_branch.hpp"
#include "graze/continuation/branch/detail/locate.hpp"
#include "graze/continuation/branch/detail/stepper.hpp"
#include "graze/continuation/branch/detail/unknown_limits.hpp"
#include "graze/continuation/special/detail/critical.hpp"

namespace graze {
namespace {

// Continues beyond a branch point from beside which no step succeeds.
//
// Points next to a branch point are badly determined along the branch that crosses. When a trace
// gets stuck on one of them it goes back a little, and then on in one step of about the same
// length.
class CrossingStep {
 public:
  // Refers to both, which must outlive it.
  CrossingStep(Corrector& corrector, Stepper& stepper) : corrector_(corrector), stepper_(stepper) {}

  // Returns the point beyond; the points too near to the branch point are dropped from the branch
  // and `h` becomes the length of the step. Returns nullopt, with the branch unchanged, when that
  // fails too.
  std::optional<SolutionPoint> pass(GrowingBranch& branch, double& h);

 private:
  std::optional<SolutionPoint> pass_within(GrowingBranch& branch, double reach);

  Corrector& corrector_;
  Stepper& stepper_;
  std::optional<Vector> stuck_;  // where no step led on last time
  double reach_ = 0.0;           // and how far pass() reached from there
};

std::optional<SolutionPoint> CrossingStep::pass(GrowingBranch& branch, double& h) {
  const Vector x = corrector_.pack(branch.last());
  std::optional<SolutionPoint> next;
  for (const double part : {1.0, 3.0, 10.0, 30.0, 100.0}) {
    h = part * kShortest * (1.0 + x.norm());
    // When this reach did not lead clear of the branch point, a longer one may: how far points are
    // badly determined depends on the accuracy of the equations.
    if (stuck_ && (*stuck_ - x).norm() <= h && h <= reach_) continue;
    next = pass_within(branch, h);
    if (next) break;
  }
  stuck_ = x;
  reach_ = h;
  return next;
}

// Goes back half of `reach`, drops the points in between, and takes a step of nearly all of it.
std::optional<SolutionPoint> CrossingStep::pass_within(GrowingBranch& branch, double reach) {
  const Vector x = corrector_.pack(branch.last());
  const auto distance = [&](const SolutionPoint& p) { return (corrector_.pack(p) - x).norm(); };
  std::size_t keep = branch.size();
  while (keep > 0 && distance(branch[keep - 1]) < 0.5 * reach) --keep;
  if (keep < 2) return {};
  SolutionPoint base = branch[keep - 1];
  const SolutionPoint* before = &branch[keep - 2];
  const double back = (x - corrector_.pack(base)).dot(base.tangent) - 0.5 * reach;
  if (back > 0.0) {
    const std::optional<SolutionPoint> nearer =
        corrector_.on_hyperplane(stepper_.prediction(before, base, back), base.tangent);
    if (!nearer || nearer->orientation != base.orientation) return {};
    before = &branch[keep - 1];
    base = *nearer;
  }
  double turn = 0.0;
  std::optional<SolutionPoint> next = stepper_.step(before, base, 0.9 * reach, turn, reach);
  if (!next) return {};
  branch.keep(keep);
  if (back > 0.0) branch.add(base);
  return next;
}

// Growth of the step after an easy one, and the turn of the tangent (relative to the largest
// allowed) that steps aim at.
constexpr double kGrowth = 1.5;
constexpr double kAimedTurn = 0.5;
// First step, relative to the longest: there are no points before it for a prediction.
constexpr double kFirstStep = 0.1;

class Tracer {
 public:
  Tracer(const ZeroProblem& problem, const ContinuationOptions& options)
      : problem_(problem),
        options_(options),
        corrector_(problem, options),
        stepper_(options, corrector_),
        crossing_(corrector_, stepper_) {}

  Branch trace(const SolutionPoint& from, Directions directions) {
    SolutionPoint start = from;
    if (problem_.multipliers && start.multipliers.empty())
      start.multipliers = problem_.multipliers(start.u, start.parameters(), ErrorBounds::kGiven);
    Branch branch = follow(start);
    if (branch.closed()) {
      branch.ends[0] = BranchEnd::kClosed;
    } else if (directions == Directions::kBoth) {
      start.turn_round();
      branch = joined(follow(start), branch);
    } else {
      branch.ends[0] = BranchEnd::kStart;
    }
    add_critical_points(branch, problem_, corrector_, options_.stop);
    branch.evaluations = corrector_.evaluations();
    return branch;
  }

 private:
  // One way, along the tangent of the start.
  Branch follow(const SolutionPoint& start) {
    GrowingBranch branch(problem_, options_, corrector_, start);
    const ParameterLimits limits(options_);
    const UnknownLimits unknowns(options_);
    double h = kFirstStep * stepper_.longest(start);
    while (true) {
      const StopReason stop = options_.stop.reason();
      if (stop != StopReason::kNone)
        return ended(branch,
                     stop == StopReason::kOutOfTime ? BranchEnd::kOutOfTime : BranchEnd::kStopped);
      if (static_cast<int>(branch.size()) > options_.max_points)
        return ended(branch, BranchEnd::kStepLimit);
      if (limits.leaves_at(branch.last())) return ended(branch, BranchEnd::kParameterLimit);
      if (unknowns.leaves_at(branch.last())) return ended(branch, BranchEnd::kUnknownLimit);
      double turn = 0.0;
      const std::optional<SolutionPoint> next = next_point(branch, h, turn);
      if (!next) return ended(branch, BranchEnd::kNotConverged);
      const SolutionPoint from = branch.last();
      if (branch.advance(*next)) return branch.take();
      if (options_.proceed && !options_.proceed(from, branch.last()))
        return ended(branch, BranchEnd::kHalted);
      h *= std::clamp(kAimedTurn * options_.max_turn / std::max(turn, 1e-12), 0.5, kGrowth);
    }
  }

  static Branch ended(GrowingBranch& branch, BranchEnd end) {
    branch.end(end);
    return branch.take();
  }

  // The end of a step, which is halved until it is accepted; h becomes the accepted length.
  std::optional<SolutionPoint> next_point(GrowingBranch& branch, double& h, double& turn) {
    const double longest = std::min(h, stepper_.longest(branch.last()));
    if (auto next = halved_step(branch, h = longest, turn, Stepper::WayBack::kJudged)) return next;
    if (branch.last().orientation == 0)
      if (auto next = halved_step(branch, h = longest, turn, Stepper::WayBack::kLeftOut))
        return next;
    if (!corrector_.pack(branch.last()).allFinite()) return {};
    return crossing_.pass(branch, h);
  }

  std::optional<SolutionPoint> halved_step(GrowingBranch& branch, double& h, double& turn,
                                           Stepper::WayBack way_back) {
    // Below this the two ends of a step are the same point in double precision.
    const double least = 1e3 * std::numeric_limits<double>::epsilon() *
                         (1.0 + corrector_.pack(branch.last()).norm());
    do {
      if (auto next = stepper_.step(branch.before_last(), branch.last(), h, turn, 0.0, way_back))
        return next;
      branch.count_rejected();
      h *= 0.5;
    } while (h >= least);
    return {};
  }

  const ZeroProblem& problem_;
  const ContinuationOptions& options_;
  Corrector corrector_;
  Stepper stepper_;
  CrossingStep crossing_;
};

}  // namespace

std::optional<SolutionPoint> solve_at(const ZeroProblem& problem,
                                      const ContinuationOptions& options, const Vector& u,
                                      double parameter) {
  Corrector corrector(problem, options);
  Vector x(u.size() + 1);
  x << u, parameter / corrector.range();
  std::optional<SolutionPoint> point = corrector.at_parameter(x);
  if (point) point->parameter = parameter;
  return point;
}

std::optional<SolutionPoint> solve_near(const ZeroProblem& problem,
                                        const ContinuationOptions& options, const Vector& u,
                                        double parameter, const Vector& along) {
  Corrector corrector(problem, options);
  Vector x(u.size() + 1);
  x << u, parameter / corrector.range();
  if (along.size() > 0) return corrector.on_hyperplane(x, along.normalized());
  const std::optional<Matrix> slope = corrector.slope_at(x);
  if (!slope) return {};
  Vector kernel = null_vector(*slope);
  if (kernel[kernel.size() - 1] < 0.0) kernel *= -1.0;
  return corrector.on_hyperplane(x, kernel);
}

Branch trace_branch(const ZeroProblem& problem, const ContinuationOptions& options,
                    const SolutionPoint& start, Directions directions) {
  return Tracer(problem, options).trace(start, directions);
}

std::optional<SolutionPoint> locate(const ZeroProblem& problem, const ContinuationOptions& options,
                                    const SolutionPoint& a, const SolutionPoint& b,
                                    const std::function<double(const SolutionPoint&)>& test) {
  Corrector corrector(problem, options);
  return locate(corrector, a, b, test);
}

bool lies_on(const ZeroProblem& problem, const ContinuationOptions& options, const Branch& branch,
             const SolutionPoint& point) {
  Corrector corrector(problem, options);
  for (std::size_t i = 0; i + 1 < branch.points.size(); ++i)
    if (lies_between(corrector, branch.points[i], branch.points[i + 1], point, options.max_turn))
      return true;
  return false;
}

}  // namespace graze
