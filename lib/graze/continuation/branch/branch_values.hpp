// A branch of solutions of a zero problem as a value: its points, its special points, how it ends;
// and the options of its continuation. branch.hpp traces one.
//
// A solution is x = (u, parameter/range) in R^(n + 1), `range` the length of the parameter's range.
#pragma once

#include <array>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/base/stop_signal.hpp"
#include "graze/base/vector.hpp"

namespace graze {

// How a special point was located: the values of the parameter between which it lies, as far as the
// branch was seen from both sides, and whether it was solved for, or enclosed, to the last digits
// of its equations. For a fold the value itself is an end.
struct Bracket {
  double from = 0.0, to = 0.0;  // from <= to
  bool converged = false;
};

// The smallest bracket that contains all of these values.
Bracket bracket_around(std::initializer_list<double> values, bool converged);

// Any solution on a branch; a branch point BP is CriticalKind::kBranchPoint.
struct SolutionPoint {
  Vector u;
  double parameter = 0.0;
  Vector tangent;         // unit, in (u, parameter/range), n + 1
  double residual = 0.0;  // largest entry of F, recomputed at the point
  // Sign of det [dF/dx; tangent]: constant along a branch, also at folds; it changes at branch
  // points. 0 on a branch point.
  int orientation = 0;
  std::vector<Eigenvalue> multipliers;  // where the problem has them
  std::optional<Bracket> bracket{};     // of one that was located between others

  // The parameter values as ZeroProblem expects them.
  std::span<const double> parameters() const { return {&parameter, 1}; }
  // Rate of the parameter along the branch, in ranges: zero at a fold.
  double rate() const { return tangent[tangent.size() - 1]; }
  // The same solution on the branch run backwards.
  void turn_round() {
    tangent *= -1.0;
    orientation *= -1;
  }
};

// The range of an unknown. A branch ends on either side of it as at a limit of the parameter.
struct UnknownRange {
  Eigen::Index unknown = 0;     // its place in u
  double from = 0.0, to = 1.0;  // either order
  double max_step = 0.0;        // largest change of it along the tangent of one step; 0: any
};

// A branch ends after this many points in one direction.
inline constexpr int kMostBranchPoints = 20000;

struct ContinuationOptions {
  double from = 0.0, to = 1.0;         // range of the parameter, either order
  double max_step = 0.0;               // largest change of the parameter in one step; 0: range/50
  std::vector<UnknownRange> ranges{};  // of unknowns that have one
  // Largest move of the unknowns in one step, relative to 1 + their norm.
  double max_distance = 0.05;
  // Largest turn of the tangent in one step, rad. Sharper turns mean that the step is too long for
  // the branch, or that it landed on another one.
  double max_turn = 0.3;
  // Largest entry of F at an accepted point; or, where F is so large that its rounding is more, of
  // Newton's correction of x, relative to 1 + |x|.
  double residual_tolerance = 1e-11;
  int max_points = kMostBranchPoints;  // in each direction
  StopSignal stop{};
  // Called with the ends of every step; false: the step is too long to show what happens within it,
  // and is taken shorter. Empty: no step is.
  std::function<bool(const SolutionPoint& from, const SolutionPoint& to)> resolves{};
  // Called with every new point and the previous one; false ends the branch there. Empty: goes on.
  std::function<bool(const SolutionPoint& previous, const SolutionPoint& here)> proceed{};
};

enum class BranchEnd {
  kParameterLimit,
  kUnknownLimit,  // of the range of an unknown
  kClosed,        // came back to where it started
  kStepLimit,     // max_points reached
  kStart,         // its start: it was not traced that way
  kNotConverged,  // no step, however small, converges
  kHalted,        // `proceed` said no
  kOutOfTime,     // the budget of computing time is spent
  kStopped        // from outside
};

enum class CriticalKind {
  kFold,            // LP: the branch turns back
  kPeriodDoubling,  // PD: a multiplier passes -1
  kTorus,           // NS: a complex pair of multipliers passes the unit circle
  kBranchPoint,     // BP: another branch of solutions crosses
  kLevel,           // UZ: a number of the caller's own takes a value
  kExtreme          // EX: it is largest or smallest
};

// UZ and EX.
inline bool is_of_level(CriticalKind kind) {
  return kind == CriticalKind::kLevel || kind == CriticalKind::kExtreme;
}

// "LP", "PD", "NS", "BP", "UZ", "EX".
const char* label_of(CriticalKind kind);

// A special point.
struct CriticalPoint {
  CriticalKind kind = CriticalKind::kFold;
  SolutionPoint point;
  std::size_t after = 0;                 // lies between points after and after + 1
  std::optional<Eigenvalue> multiplier;  // the critical one; of a pair the one with positive
                                         // imaginary part
  std::size_t level = 0;                 // of UZ and EX: which of the numbers
};

struct Branch {
  std::vector<SolutionPoint> points;    // in order along the branch; a closed one repeats its first
  std::vector<CriticalPoint> critical;  // in order along the branch
  std::array<BranchEnd, 2> ends{BranchEnd::kNotConverged, BranchEnd::kNotConverged};
  long long evaluations = 0;  // of F
  long long rejected = 0;     // steps refused for turning, contracting slowly or not converging

  bool closed() const { return ends[1] == BranchEnd::kClosed; }
  std::vector<CriticalPoint> critical_of(CriticalKind kind) const;
};

}  // namespace graze
