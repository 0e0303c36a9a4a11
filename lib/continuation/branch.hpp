// Pseudo-arclength continuation of F(u, parameter) = 0, F: R^n x R -> R^n. Generic: it knows
// nothing of what the equations stand for.
//
//   #include "graze/continuation/branch.hpp"
//
// A point is x = (u, parameter/range); the predictor follows the unit tangent, the corrector is
// Newton's method on F bordered by the hyperplane through the prediction. It passes folds. The
// metric is Euclidean: scale the unknowns so that a change of one is large.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/base/vector.hpp"

namespace graze {

struct ZeroEvaluation {
  Vector residual;              // F, n
  Matrix jacobian;              // dF/du, n x n
  Vector parameter_derivative;  // dF/dparameter, n
};

struct ZeroProblem {
  // Nothing where F cannot be evaluated.
  std::function<std::optional<ZeroEvaluation>(const Vector& u, double parameter)> evaluate;
  // For unknowns that are angles: their period; 0 for the others. Empty: no angles.
  Vector wrap;
};

struct BranchPoint {
  Vector u;
  double parameter = 0.0;
  Vector tangent;         // unit, in (u, parameter/range), n + 1
  double residual = 0.0;  // largest entry of F, recomputed at the point
  // Sign of det [dF/dx; tangent]: constant along a branch, folds included, but for branch points.
  int orientation = 0;
};

// A branch is given up after this many points in one direction.
inline constexpr int kMostBranchPoints = 20000;

struct ContinuationOptions {
  double from = 0.0, to = 1.0;  // range of the parameter, either order
  double max_step = 0.0;        // largest change of the parameter in one step; 0: range/50
  // Largest move of the unknowns in one step, relative to 1 + their norm.
  double max_distance = 0.05;
  // Largest turn of the tangent in one step, rad. Sharper turns mean that the step is too long for
  // the branch, or that it landed on another one.
  double max_turn = 0.3;
  double residual_tolerance = 1e-11;   // largest entry of F at an accepted point
  int max_points = kMostBranchPoints;  // in each direction
  StopSignal stop;
  // Asked of every new point; false ends the branch there. Empty: go on.
  std::function<bool(const BranchPoint&)> proceed;
};

enum class BranchEnd {
  kParameterLimit,
  kClosed,        // came back to where it started
  kStepLimit,     // max_points reached
  kNotConverged,  // no step, however small, converges
  kHalted,        // `proceed` said no
  kStopped        // from outside
};

struct Fold {
  BranchPoint point;
  std::size_t after = 0;  // lies between points after and after + 1
};

struct Branch {
  std::vector<BranchPoint> points;  // in order along the branch; a closed one repeats its first
  std::vector<Fold> folds;          // in order
  std::array<BranchEnd, 2> ends{BranchEnd::kNotConverged, BranchEnd::kNotConverged};
  long long evaluations = 0;  // of F
  long long rejected = 0;     // steps refused for turning, contracting slowly or not converging

  bool closed() const { return ends[1] == BranchEnd::kClosed; }
};

// The solution near u at a fixed parameter, with a tangent that points to growing parameter (or
// along growing arclength at a fold). Nothing when Newton's method does not reach the tolerance.
std::optional<BranchPoint> solve_at(const ZeroProblem& problem, const ContinuationOptions& options,
                                    const Vector& u, double parameter);

// The branch through a solution, both ways to their ends, folds located.
Branch trace_branch(const ZeroProblem& problem, const ContinuationOptions& options,
                    const BranchPoint& start);

// The point of the branch between neighbours a and b where `test` changes sign, to the last digits
// that arclength carries and on the side where `test` is not negative. Nothing when the corrector
// fails on the way or the signs agree.
std::optional<BranchPoint> locate(const ZeroProblem& problem, const ContinuationOptions& options,
                                  const BranchPoint& a, const BranchPoint& b,
                                  const std::function<double(const BranchPoint&)>& test);

// Whether a solution lies on a traced branch.
bool lies_on(const ZeroProblem& problem, const ContinuationOptions& options, const Branch& branch,
             const BranchPoint& point);

}  // namespace graze
