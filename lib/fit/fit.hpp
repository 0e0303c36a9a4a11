// Parameters of a scene from measurements: the values for which the sum of squares of what was
// measured less what the scene says, each in units of its uncertainty, is least, and how well the
// data determine them.
//
//   covariance   s^2 (J^T J)^-1,   s^2 = sum of squares/(m - n)
//   interval     value -+ t s_j,   t the 97.5 % quantile of Student's distribution, m - n degrees
//
// J the derivative of m values by n parameters at the optimum. Where the uncertainties of the data
// are known s = 1, and t is that of the normal distribution. What holds for the interval of a
// linear model with normal noise holds near enough where the model is linear over the interval.
//   G. A. F. Seber, C. J. Wild, Nonlinear Regression, Wiley 1989, chapter 2.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/fit/measurements.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// A parameter that is sought between two values; infinite where there are none.
struct SoughtParameter {
  std::string name;
  double low = 0.0, high = 0.0;
};

struct FitOptions {
  std::vector<SoughtParameter> parameters;  // empty: of restitutions, all coefficients of the scene
  bool global = false;
  long long max_evaluations = 0;  // of the model
  std::optional<double> closure_speed{};
  long long max_impacts = 0;  // of one motion
  StopSignal stop{};
  std::function<void(double part)> progress{};
};

enum class FitEnd {
  kFitted,
  kNotDetermined,  // the data do not tell all parameters
  kNotConverged,
  kBudget,
  kInterrupted
};

struct FittedParameter {
  std::string name, unit;
  double start = 0.0, low = 0.0, high = 0.0;  // where the search began, its limits
  double value = 0.0;
  bool at_limit = false;  // held there: the sum of squares would fall beyond it
  // Standard uncertainty and the ends of the 95 % interval; nothing for what is held at a limit or
  // not determined.
  std::optional<double> uncertainty{};
  double interval_low = 0.0, interval_high = 0.0;
};

// One measured series beside the model.
struct FittedSeries {
  std::string name, unit;
  Vector measured, predicted, uncertainty;  // one per row; uncertainty empty where it is unknown
  double noise = 0.0;  // standard deviation of the values: of the residuals, or as it is known
};

struct FitResult {
  FitEnd end = FitEnd::kNotConverged;
  std::string message;  // a sentence unless it is fitted
  std::string method;   // in words
  MeasurementKind kind = MeasurementKind::kResponse;
  std::vector<FittedParameter> parameters;
  // Of the parameters, n x n; NaN with those that have no uncertainty.
  Matrix correlations;
  Vector at;  // as measured
  std::vector<FittedSeries> series;
  // The model at more places, for a picture: where, and one column a series.
  Vector curve_at;
  Matrix curve;
  double sum_of_squares = 0.0;  // in units of the uncertainties; of the first series' where unknown
  long long freedom = 0;        // m - n, those held at limits not counted
  bool knows_uncertainty = false;
  double quantile = 0.0;  // t
  long long evaluations = 0;
  std::optional<Scene> fitted;        // the scene with these values
  std::vector<std::string> warnings;  // sentences
};

// Throws InputError for parameters that cannot be sought, and for measurements that are too few for
// them or far from all that the scene says (with file:line:column).
FitResult fit(const Scene& scene, const Measurements& measurements, const FitOptions& options);

// The 97.5 % quantile of Student's distribution; of the normal one for `freedom` 0.
double confidence_quantile(long long freedom);

}  // namespace graze
