#include "graze/fit/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/fit/detail/fit_model.hpp"
#include "graze/fit/detail/fit_preparation.hpp"
#include "graze/fit/detail/least_squares.hpp"
#include "graze/fit/detail/parameter_uncertainty.hpp"
#include "graze/scene/parameter.hpp"

namespace graze {
namespace {

// Points of a curve in a picture.
constexpr Eigen::Index kCurvePoints = 801;

// The unit of each value's deviation: its uncertainty where that is known, else the size of its
// series, so that sums of squares are pure numbers.
Vector deviation_units(const Measurements& measurements) {
  const auto rows = static_cast<Eigen::Index>(measurements.rows());
  Vector units(measurements.values());
  Eigen::Index place = 0;
  for (const MeasuredSeries& series : measurements.series) {
    const double size = series.values.cwiseAbs().maxCoeff();
    units.segment(place, rows) = series.uncertainty.size() > 0
                                     ? series.uncertainty
                                     : Vector::Constant(rows, size > 0.0 ? size : 1.0);
    place += rows;
  }
  return units;
}

Vector measured_values(const Measurements& measurements) {
  const auto rows = static_cast<Eigen::Index>(measurements.rows());
  Vector values(measurements.values());
  Eigen::Index place = 0;
  for (const MeasuredSeries& series : measurements.series) {
    values.segment(place, rows) = series.values;
    place += rows;
  }
  return values;
}

// Whether the parameter is positive with a range of more than a decade.
bool is_logarithmic(const SoughtParameter& parameter) {
  return parameter.low > 0.0 && std::isfinite(parameter.high) &&
         parameter.high > 10.0 * parameter.low;
}

double middle(const SoughtParameter& parameter) {
  return is_logarithmic(parameter) ? std::sqrt(parameter.low) * std::sqrt(parameter.high)
                                   : 0.5 * (parameter.low + parameter.high);
}

class Fit {
 public:
  Fit(const Scene& scene, const Measurements& measurements, const FitOptions& options)
      : measurements_(measurements),
        options_(options),
        parameters_(checked_parameters(scene, measurements, options.parameters)),
        model_(scene, measurements, names(),
               {options.closure_speed, options.max_impacts, options.stop}),
        measured_(measured_values(measurements)),
        units_(deviation_units(measurements)) {}

  FitResult run() {
    require_enough(measurements_, parameters_);
    const LeastSquaresProblem problem = posed();
    require_comparable(measurements_, parameters_, problem.start, model_, options_.stop);
    if (options_.begins) options_.begins();
    LeastSquaresOptions options{options_.global, options_.max_evaluations, options_.stop,
                                options_.progress};
    const LeastSquaresResult solved = solve_least_squares(problem, options);
    describe(problem, solved);
    if (solved.residuals.size() > 0) show(solved);
    return std::move(result_);
  }

 private:
  std::vector<std::string> names() const {
    std::vector<std::string> list;
    for (const SoughtParameter& parameter : parameters_) list.push_back(parameter.name);
    return list;
  }

  LeastSquaresProblem posed() {
    const auto n = static_cast<Eigen::Index>(parameters_.size());
    LeastSquaresProblem problem;
    problem.start = model_.start();
    problem.low.resize(n);
    problem.high.resize(n);
    for (Eigen::Index j = 0; j < n; ++j) {
      const SoughtParameter& parameter = parameters_[static_cast<std::size_t>(j)];
      problem.low[j] = parameter.low;
      problem.high[j] = parameter.high;
      problem.logarithmic.push_back(is_logarithmic(parameter));
      const double value = problem.start[j];
      if (!(value >= parameter.low && value <= parameter.high))
        problem.start[j] = middle(parameter);
    }
    problem.residuals = [this](const Vector& p) -> std::optional<Vector> {
      const std::optional<Vector> predicted = model_.predict(p);
      if (!predicted) return {};
      return Vector((*predicted - measured_).cwiseQuotient(units_));
    };
    problem.linear = measurements_.kind == MeasurementKind::kRestitution;
    if (problem.linear)
      problem.jacobian = [this](const Vector&) -> Matrix {
        return units_.cwiseInverse().asDiagonal() * *model_.derivative();
      };
    problem.size = measured_.cwiseQuotient(units_).norm();
    problem.noise = measurements_.knows_uncertainty() ? 1.0 : 0.0;
    return problem;
  }

  void describe(const LeastSquaresProblem& problem, const LeastSquaresResult& solved) {
    result_.kind = measurements_.kind;
    result_.at = measurements_.at;
    result_.method = solved.method;
    result_.evaluations = solved.evaluations;
    result_.knows_uncertainty = measurements_.knows_uncertainty();
    std::size_t held = 0;
    for (std::size_t j = 0; j < parameters_.size(); ++j) {
      const auto k = static_cast<Eigen::Index>(j);
      FittedParameter parameter{parameters_[j].name, model_.units()[j]};
      parameter.start = problem.start[k];
      parameter.low = parameters_[j].low;
      parameter.high = parameters_[j].high;
      parameter.value = solved.parameters[k];
      parameter.at_limit = solved.at_limit[j];
      held += parameter.at_limit ? 1 : 0;
      result_.parameters.push_back(parameter);
    }
    result_.freedom = static_cast<long long>(measurements_.values()) -
                      static_cast<long long>(parameters_.size() - held);
    set_end(solved);
  }

  void set_end(const LeastSquaresResult& solved) {
    const auto end = [&](FitEnd kind, const std::string& sentence) {
      result_.end = kind;
      result_.message = sentence;
    };
    switch (solved.end) {
      case LeastSquaresEnd::kConverged:
        result_.end = FitEnd::kFitted;
        break;
      case LeastSquaresEnd::kNotConverged:
        end(FitEnd::kNotConverged,
            "the sum of squares falls no further, but the model's derivatives ask for more than a "
            "thousandth of the noise: it is not smooth enough here, or the start was too far off "
            "(--algorithm global)");
        break;
      case LeastSquaresEnd::kNoValue:
        end(FitEnd::kNotConverged,
            fmt::format("the model says nothing at the start and near it: {}", model_.why()));
        break;
      case LeastSquaresEnd::kBudget:
        end(FitEnd::kBudget, fmt::format("the budget of {} evaluations of the model was spent",
                                         options_.max_evaluations));
        break;
      case LeastSquaresEnd::kStopped:
        if (options_.stop.is_interrupted())
          end(FitEnd::kInterrupted, "interrupted; the values are the best so far");
        else
          end(FitEnd::kBudget, "the budget of computing time was spent");
    }
  }

  void show(const LeastSquaresResult& solved) {
    result_.sum_of_squares = solved.residuals.squaredNorm();
    result_.quantile = confidence_quantile(result_.knows_uncertainty ? 0 : result_.freedom);
    add_series(solved.residuals);
    if (solved.end == LeastSquaresEnd::kConverged) {
      judge_parameters(solved, result_);
      judge_residuals(solved.residuals, result_);
    }
    require_all_impacts(solved.parameters);
    warn_of_clamped_restitution();
    add_curve(solved.parameters);
    try {
      result_.fitted = model_.scene_at(solved.parameters);
      name_units(*result_.fitted);
    } catch (const InputError& error) {
      result_.warnings.push_back(
          fmt::format("no scene can have these values together: {}", error.what()));
    }
  }

  // In units with an exponent that is itself fitted, that exponent is written as a letter.
  void name_units(const Scene& fitted) {
    for (FittedParameter& parameter : result_.parameters) {
      if (!parameter_value(fitted, parameter.name) ||
          parameter_unit(fitted, parameter.name) == parameter.unit)
        continue;
      parameter.unit = parameter.name.ends_with(".stiffness") ? "N/m^n" : "N s/m^(n+1)";
    }
  }

  void add_series(const Vector& residuals) {
    const auto rows = static_cast<Eigen::Index>(measurements_.rows());
    const double noise =
        std::sqrt(result_.sum_of_squares / static_cast<double>(std::max(result_.freedom, 1LL)));
    Eigen::Index place = 0;
    for (const MeasuredSeries& series : measurements_.series) {
      const auto part = [&](const Vector& all) { return all.segment(place, rows); };
      FittedSeries fitted{series.name, series.unit, series.values, {}, series.uncertainty, 0.0};
      const Vector missed = part(residuals).cwiseProduct(part(units_));
      fitted.predicted = series.values + missed;
      fitted.noise = series.uncertainty.size() > 0
                         ? std::sqrt(missed.squaredNorm() / static_cast<double>(rows))
                         : noise * units_[place];
      result_.series.push_back(fitted);
      place += rows;
    }
  }

  void require_all_impacts(const Vector& values) {
    if (measurements_.kind != MeasurementKind::kImpactTimes || options_.stop.requested()) return;
    model_.predict(values);
    if (model_.missing_impacts() == 0) return;
    result_.end = FitEnd::kNotConverged;
    result_.message =
        model_.why() +
        ": nothing near the start has as many (--algorithm global, other limits, or a "
        "record without what is no impact)";
  }

  void warn_of_clamped_restitution() {
    if (measurements_.kind != MeasurementKind::kRestitution) return;
    const Vector& fitted = result_.series[0].predicted;
    if (fitted.minCoeff() < 0.0 || fitted.maxCoeff() > 1.0)
      result_.warnings.emplace_back(
          "r(v) leaves 0..1 at measured speeds, where a motion takes 0 or 1 instead");
  }

  void add_curve(const Vector& values) {
    if (measurements_.kind == MeasurementKind::kImpactTimes || options_.stop.requested()) return;
    const bool pairs = measurements_.kind == MeasurementKind::kRestitution;
    const double first = pairs ? 0.0 : measurements_.at.minCoeff();
    const Vector at = Vector::LinSpaced(kCurvePoints, first, measurements_.at.maxCoeff());
    const std::optional<Vector> curve = model_.predict_at(values, at);
    if (!curve) return;
    result_.curve_at = at;
    result_.curve = curve->reshaped(at.size(), curve->size() / at.size());
  }

  const Measurements& measurements_;
  const FitOptions& options_;
  const std::vector<SoughtParameter> parameters_;
  FitModel model_;
  const Vector measured_, units_;
  FitResult result_;
};

}  // namespace

FitResult fit(const Scene& scene, const Measurements& measurements, const FitOptions& options) {
  return Fit(scene, measurements, options).run();
}

}  // namespace graze
