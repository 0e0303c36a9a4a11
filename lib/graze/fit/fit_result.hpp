// Options and results of a fit.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/fit/measurements.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// A fitted parameter and its limits; infinite where there are none.
struct SoughtParameter {
  std::string name;
  double low = 0.0, high = 0.0;
};

struct FitOptions {
  std::vector<SoughtParameter> parameters;  // empty: for restitutions, all coefficients of the
                                            // scene
  bool global = false;
  long long max_evaluations = 0;  // of the model
  std::optional<double> closure_speed{};
  long long max_impacts = 0;  // of one motion
  StopSignal stop{};
  std::function<void()> begins{};  // called when all is checked, before the search
  std::function<void(double part)> progress{};
};

enum class FitEnd {
  kFitted,
  kNotDetermined,  // the data do not determine all parameters
  kNotConverged,
  kBudget,
  kInterrupted
};

struct FittedParameter {
  std::string name, unit;
  double start = 0.0, low = 0.0, high = 0.0;  // where the search began, its limits
  double value = 0.0;
  bool at_limit = false;  // held there: the sum of squares would be smaller beyond it
  // Standard uncertainty and the ends of the 95 % interval; nullopt when the parameter is held at a
  // limit or not determined.
  std::optional<double> uncertainty{};
  double interval_low = 0.0, interval_high = 0.0;
};

// One measured series beside the model.
struct FittedSeries {
  std::string name, unit;
  Vector measured, predicted, uncertainty;  // one per row; uncertainty empty where it is unknown
  double noise = 0.0;  // standard deviation of the values: from the residuals, or as given
};

struct FitResult {
  FitEnd end = FitEnd::kNotConverged;
  std::string message;  // a sentence unless it is fitted
  std::string method;   // in words
  MeasurementKind kind = MeasurementKind::kResponse;
  std::vector<FittedParameter> parameters;
  // Of the parameters, n x n; NaN for those without uncertainty.
  Matrix correlations;
  Vector at;  // as measured
  std::vector<FittedSeries> series;
  // The model at more places, for a picture: the places, and one column for each series.
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

}  // namespace graze
