#include "graze/fit/detail/fit_preparation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "graze/scene/parameter.hpp"

namespace graze {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
// From one unit to the next (mm to m, kN to N, ms to s) the factor is a thousand: parameters do not
// explain more than a hundred.
constexpr double kFarOff = 100.0;

std::vector<std::string> restitution_names(const Scene& scene) {
  if (scene.stops.empty() || scene.stops.front().spring)
    throw InputError(
        "pairs of speed and restitution are fitted to stop.restitution, which the scene does not "
        "have: its first stop must be there and be rigid");
  const std::size_t count = scene.stops.front().restitution.size();
  if (count == 1) return {"stop.restitution"};
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= count; ++i) names.push_back(fmt::format("stop.restitution.{}", i));
  return names;
}

bool is_first_coefficient(const std::string& name) {
  return name.ends_with(".restitution") || name.ends_with(".restitution.1");
}

void check_limit(const Scene& scene, const SoughtParameter& parameter, double value) {
  if (!std::isfinite(value) || !parameter_value(scene, parameter.name)) return;
  try {
    with_parameter(scene, parameter.name, value);
  } catch (const InputError& error) {
    throw InputError(fmt::format("--parameter {}: the scene does not allow the limit {:g}: {}",
                                 parameter.name, value, error.what()));
  }
}

// A response is measured over the motion, which begins at 0.
void check_record_start(const Measurements& measurements, const SoughtParameter& parameter) {
  if (parameter.name != kRecordStart || measurements.kind != MeasurementKind::kResponse) return;
  const double first = measurements.at.minCoeff();
  if (parameter.low + first >= 0.0) return;
  throw InputError(
      fmt::format("--parameter record.start: at the limit {:g} s the record would begin before the "
                  "motion does; "
                  "allowed is {:g} s or more, the first time of {} less",
                  parameter.low, -first, measurements.file));
}

double size_of(const Vector& values) { return values.cwiseAbs().maxCoeff(); }

// Smallest and largest sizes of each series of the model.
class ModelSizes {
 public:
  explicit ModelSizes(const Measurements& measurements)
      : rows_(static_cast<Eigen::Index>(measurements.rows())),
        least_(measurements.series.size(), kNoLimit),
        most_(measurements.series.size(), 0.0) {}

  void include(const Vector& predicted) {
    for (std::size_t k = 0; k < most_.size(); ++k) {
      const double size = size_of(predicted.segment(static_cast<Eigen::Index>(k) * rows_, rows_));
      least_[k] = std::min(least_[k], size);
      most_[k] = std::max(most_[k], size);
    }
  }
  double least(std::size_t k) const { return least_[k]; }
  double most(std::size_t k) const { return most_[k]; }

 private:
  Eigen::Index rows_;
  std::vector<double> least_, most_;
};

void compare(const Measurements& measurements, std::size_t k, const ModelSizes& sizes,
             Units units) {
  const MeasuredSeries& series = measurements.series[k];
  Eigen::Index row = 0;
  const double measured = series.values.cwiseAbs().maxCoeff(&row);
  const SourceLocation& place = measurements.places[static_cast<std::size_t>(row)];
  const std::string unit = unit_behind(units, series.unit);
  const char* remark = units == Units::kSi ? "; units are SI" : "";
  const auto error = [&](const std::string& sentence) {
    return InputError(place, "data", fmt::format("{}: {}", series.name, sentence));
  };
  const char* where = "at the scene's values and at the limits of the parameters";
  if (sizes.most(k) == 0.0)
    throw error(
        fmt::format("the values reach {:g}{}, but {} the model's are zero over the whole record",
                    measured, unit, where));
  if (measured > kFarOff * sizes.most(k))
    throw error(
        fmt::format("the values reach {:g}{}, but {} the model's reach no more than {:.3g}{}",
                    measured, unit, where, sizes.most(k), remark));
  if (measured < sizes.least(k) / kFarOff)
    throw error(
        fmt::format("the values reach only {:g}{}, but {} the model's reach at least {:.3g}{}",
                    measured, unit, where, sizes.least(k), remark));
}

}  // namespace

std::vector<SoughtParameter> checked_parameters(const Scene& scene,
                                                const Measurements& measurements,
                                                const std::vector<SoughtParameter>& asked) {
  std::vector<SoughtParameter> parameters = asked;
  const bool pairs = measurements.kind == MeasurementKind::kRestitution;
  if (pairs) {
    const std::vector<std::string> names = restitution_names(scene);
    if (parameters.empty())
      for (const std::string& name : names) parameters.push_back({name, -kNoLimit, kNoLimit});
  }
  if (parameters.empty())
    throw InputError(
        "--parameter NAME=LOW:HIGH: name at least one parameter that is to be fitted, and between "
        "which values it is sought");
  std::set<std::string> names;
  for (SoughtParameter& parameter : parameters) {
    if (!names.insert(parameter.name).second)
      throw InputError(fmt::format("--parameter {}: it is named twice", parameter.name));
    if (pairs && is_first_coefficient(parameter.name)) {
      parameter.low = std::isfinite(parameter.low) ? parameter.low : 0.0;
      parameter.high = std::isfinite(parameter.high) ? parameter.high : 1.0;
    }
    if (!pairs && !(std::isfinite(parameter.low) && std::isfinite(parameter.high)))
      throw InputError(
          fmt::format("--parameter {0}: give the values between which it is sought, {0}=LOW:HIGH",
                      parameter.name));
    if (!(parameter.low < parameter.high))
      throw InputError(fmt::format("--parameter {}: LOW must be below HIGH, not {:g}:{:g}",
                                   parameter.name, parameter.low, parameter.high));
    check_record_start(measurements, parameter);
    check_limit(scene, parameter, parameter.low);
    check_limit(scene, parameter, parameter.high);
  }
  return parameters;
}

void require_enough(const Measurements& measurements,
                    const std::vector<SoughtParameter>& parameters) {
  const auto values = static_cast<std::size_t>(measurements.values());
  const bool known = measurements.knows_uncertainty();
  const std::size_t needed = parameters.size() + (known ? 0 : 1);
  if (values < needed)
    throw InputError(measurements.places.back(), "data",
                     fmt::format("{} value{} too few for {} parameter{}; at least {} are needed{}",
                                 values, values == 1 ? " is" : "s are", parameters.size(),
                                 parameters.size() == 1 ? "" : "s", needed,
                                 known ? "" : " where their uncertainty is to be told from them"));
  if (measurements.kind != MeasurementKind::kRestitution) return;
  const std::set<double> speeds(measurements.at.begin(), measurements.at.end());
  if (speeds.size() < parameters.size())
    throw InputError(measurements.places.back(), "data",
                     fmt::format("{} different speed{} tell no {} coefficients of the restitution",
                                 speeds.size(), speeds.size() == 1 ? "" : "s", parameters.size()));
}

void require_comparable(const Measurements& measurements,
                        const std::vector<SoughtParameter>& parameters, const Vector& start,
                        FitModel& model, const StopSignal& stop) {
  // Restitutions were checked when they were read.
  if (measurements.kind == MeasurementKind::kRestitution) return;
  ModelSizes sizes(measurements);
  bool evaluated = false, met = false;
  const auto probe = [&](const Vector& values) {
    const std::optional<Vector> predicted = model.predict(values);
    if (!predicted) return;
    evaluated = true;
    met = met || model.missing_impacts() < measurements.rows();
    sizes.include(*predicted);
  };
  probe(start);
  for (std::size_t j = 0; j < parameters.size(); ++j)
    for (const double limit : {parameters[j].low, parameters[j].high}) {
      Vector values = start;
      values[static_cast<Eigen::Index>(j)] = limit;
      probe(values);
    }
  if (!evaluated || stop.requested()) return;  // the fit says why
  if (measurements.kind == MeasurementKind::kImpactTimes && !met)
    throw InputError(
        measurements.places.back(), "data",
        fmt::format("time: at the scene's values and at the limits of the parameters the model has "
                    "no impact up to {:g}{}, twice the last time here",
                    2.0 * measurements.series[0].values.maxCoeff(),
                    unit_behind(model.scene_units(), "s")));
  for (std::size_t k = 0; k < measurements.series.size(); ++k)
    compare(measurements, k, sizes, model.scene_units());
}

}  // namespace graze
