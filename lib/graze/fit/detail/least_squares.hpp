// The parameters within their limits for which |r(p)|^2 is least: NLopt comes near, by a search of
// the whole box (DIRECT) if requested, then from a start (BOBYQA; Nelder and Mead's simplex for one
// parameter), and Gauss-Newton steps by Ceres finish, on the limits where the minimum lies there.
// The result is judged by the remaining Gauss-Newton step, not by a library's own report. Where the
// sum of squares has kinks (an impact that passes a sample) the steps stall, and a simplex finds
// the minimum.
//   D. R. Jones, C. D. Perttunen, B. E. Stuckman, J. Optim. Theory Appl. 79 (1993) 157-181.
//   M. J. D. Powell, The BOBYQA algorithm for bound constrained optimization, Cambridge 2009.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/fit/detail/least_squares_problem.hpp"

namespace graze {

struct LeastSquaresOptions {
  bool global = false;
  long long evaluations = 0;  // of the residuals, at most
  StopSignal stop{};
  std::function<void(double part)> progress{};
};

enum class LeastSquaresEnd { kConverged, kNotConverged, kBudget, kStopped, kNoValue };

struct LeastSquaresResult {
  LeastSquaresEnd end = LeastSquaresEnd::kNotConverged;
  Vector parameters;            // the best there was
  Vector residuals;             // there
  DifferenceJacobian jacobian;  // at the end; empty unless that was reached
  std::vector<bool> at_limit;   // n: held there, r would fall beyond it
  double last_step = 0.0;       // J p| of the last Gauss-Newton step
  long long evaluations = 0;
  std::string method;  // in words
};

// Noise of one residual: as given, else from the residuals of n parameters.
double residual_noise(const LeastSquaresProblem& problem, const Vector& residuals);

// A Gauss-Newton step that changes the model by less than this part of the noise of one value moves
// no parameter by more than this part of its standard uncertainty.
inline constexpr double kNoiseStep = 1e-3;

LeastSquaresResult solve_least_squares(const LeastSquaresProblem& problem,
                                       const LeastSquaresOptions& options);

}  // namespace graze
