// Pseudo-arclength continuation of F(u, parameter) = 0, F: R^n x R -> R^n. Generic: it knows
// nothing of what the equations stand for.
//
//   #include "graze/continuation/branch.hpp"
//
// A point is x = (u, parameter/range); the predictor follows the unit tangent, the corrector is
// Newton's method on F bordered by the hyperplane through the prediction. It passes folds and
// branch points. The metric is Euclidean: scale the unknowns so that a change of one is large.
//
// Special points, named as AUTO and MatCont name them: folds (LP) and branch points (BP) of any
// equations; period doublings (PD) and tori (NS) where the problem tells the multipliers of its
// solutions (map.hpp makes such a problem of a map). They are located to the last digits that
// arclength carries. See switching.hpp for going on across them.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/decompositions.hpp"
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
  // u and u + m wrap are one solution for every integer m: for unknowns that are angles. Empty
  // where nothing comes round.
  Vector wrap;
  // Multipliers of the solution at (u, parameter), where it stands for the periodic orbit of
  // something: largest modulus first, conjugate pairs adjacent, as eigenvalues() gives them, with
  // or without errors. Empty function: the equations have none.
  std::function<std::vector<Eigenvalue>(const Vector& u, double parameter, ErrorBounds errors)>
      multipliers;
};

struct BranchPoint {
  Vector u;
  double parameter = 0.0;
  Vector tangent;         // unit, in (u, parameter/range), n + 1
  double residual = 0.0;  // largest entry of F, recomputed at the point
  // Sign of det [dF/dx; tangent]: constant along a branch, folds included, but for branch points. 0
  // on a branch point.
  int orientation = 0;
  std::vector<Eigenvalue> multipliers;  // where the problem has them
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
  StopSignal stop{};
  // Asked of every new point and the one before it; false ends the branch there. Empty: go on.
  std::function<bool(const BranchPoint& previous, const BranchPoint& here)> proceed{};
};

enum class BranchEnd {
  kParameterLimit,
  kClosed,        // came back to where it started
  kStepLimit,     // max_points reached
  kNotConverged,  // no step, however small, converges
  kHalted,        // `proceed` said no
  kOutOfTime,     // the budget of computing time is spent
  kStopped        // from outside
};

enum class CriticalKind {
  kFold,            // LP: the branch turns back
  kPeriodDoubling,  // PD: a multiplier passes -1
  kTorus,           // NS: a complex pair of multipliers passes the unit circle
  kBranchPoint      // BP: another branch of solutions crosses
};

// "LP", "PD", "NS", "BP".
const char* label_of(CriticalKind kind);

struct CriticalPoint {
  CriticalKind kind = CriticalKind::kFold;
  BranchPoint point;
  std::size_t after = 0;                 // lies between points after and after + 1
  std::optional<Eigenvalue> multiplier;  // the critical one; of a pair that with positive imag
};

struct Branch {
  std::vector<BranchPoint> points;      // in order along the branch; a closed one repeats its first
  std::vector<CriticalPoint> critical;  // in order along the branch
  std::array<BranchEnd, 2> ends{BranchEnd::kNotConverged, BranchEnd::kNotConverged};
  long long evaluations = 0;  // of F
  long long rejected = 0;     // steps refused for turning, contracting slowly or not converging

  bool closed() const { return ends[1] == BranchEnd::kClosed; }
  std::vector<CriticalPoint> critical_of(CriticalKind kind) const;
};

// The solution near u at a fixed parameter, with a tangent that points to growing parameter (or
// along growing arclength at a fold). Nothing when Newton's method does not reach the tolerance.
std::optional<BranchPoint> solve_at(const ZeroProblem& problem, const ContinuationOptions& options,
                                    const Vector& u, double parameter);

enum class Directions { kBoth, kForward };  // forward: along the tangent of the start

// The branch through a solution, to its ends, its special points located.
Branch trace_branch(const ZeroProblem& problem, const ContinuationOptions& options,
                    const BranchPoint& start, Directions directions = Directions::kBoth);

// The point of the branch between neighbours a and b where `test` changes sign, to the last digits
// that arclength carries and on the side where `test` is not negative. Nothing when the corrector
// fails on the way or the signs agree.
std::optional<BranchPoint> locate(const ZeroProblem& problem, const ContinuationOptions& options,
                                  const BranchPoint& a, const BranchPoint& b,
                                  const std::function<double(const BranchPoint&)>& test);

// Whether the branch passes a branch point at this solution.
bool crosses_at(const ZeroProblem& problem, const ContinuationOptions& options,
                const Branch& branch, const BranchPoint& point);

// Whether a solution lies on a traced branch.
bool lies_on(const ZeroProblem& problem, const ContinuationOptions& options, const Branch& branch,
             const BranchPoint& point);

}  // namespace graze
