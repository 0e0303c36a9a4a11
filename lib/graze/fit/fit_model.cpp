#include "graze/fit/detail/fit_model.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "graze/assembly/initial_state.hpp"
#include "graze/assembly/probes.hpp"
#include "graze/base/defaults.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/scene/check.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/start_coordinate.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {
namespace {

// A motion is followed for this many times the length of the record, so that late impacts near its
// end still have different times.
constexpr double kLonger = 2.0;

const std::vector<double>& coefficients(const Scene& scene) {
  return scene.stops.front().restitution;
}

}  // namespace

FitModel::FitModel(const Scene& scene, const Measurements& measurements,
                   const std::vector<std::string>& parameters, const FitModelOptions& options)
    : scene_(scene), measurements_(measurements), options_(options) {
  const bool moves = measurements.kind != MeasurementKind::kRestitution;
  std::vector<std::string> of_scene;
  start_.resize(0);
  for (const std::string& name : parameters) {
    add(name);
    if (parameters_.back().target == Target::kScene) of_scene.push_back(name);
  }
  if (moves) cursor_ = std::make_unique<SystemCursor>(scene_, of_scene);
}

void FitModel::add(const std::string& name) {
  const bool moves = measurements_.kind != MeasurementKind::kRestitution;
  Parameter parameter{name, Target::kScene, 0};
  double value = 0.0;
  std::string unit;
  if (moves && name == kRecordStart) {
    parameter.target = Target::kClock;
    unit = unit_in(scene_.units, "s");
  } else if (moves && names_start_coordinate(name)) {
    parameter.target = Target::kInitialState;
    value = start_coordinate(scene_, name);
    unit = number_unit(scene_, name);
  } else {
    parameter_direction(scene_, name);  // throws for an unknown name
    value = *parameter_value(scene_, name);
    unit = parameter_unit(scene_, name);
    if (!moves) {
      check_restitution(name);
      const std::string entry = name.substr(name.rfind('.') + 1);
      const long number = std::strtol(entry.c_str(), nullptr, 10);
      parameter.coefficient = number > 0 ? static_cast<std::size_t>(number - 1) : 0;
    }
  }
  parameters_.push_back(parameter);
  units_.push_back(unit);
  start_.conservativeResize(start_.size() + 1);
  start_[start_.size() - 1] = value;
}

void FitModel::check_restitution(const std::string& name) const {
  const bool first = name == "stop.restitution" || name.starts_with("stop.restitution.") ||
                     name.starts_with("stop.1.restitution");
  if (first) return;
  throw InputError(
      fmt::format("{}: pairs of speed and restitution say nothing of it; allowed are the "
                  "coefficients of stop.restitution",
                  name));
}

std::optional<Vector> FitModel::predict(const Vector& values) {
  why_.clear();
  missing_ = 0;
  switch (measurements_.kind) {
    case MeasurementKind::kRestitution:
      return restitutions(values, measurements_.at);
    case MeasurementKind::kImpactTimes:
      return impact_times(values);
    case MeasurementKind::kResponse:
      break;
  }
  return responses(values, measurements_.at);
}

std::optional<Vector> FitModel::predict_at(const Vector& values, const Vector& at) {
  why_.clear();
  return measurements_.kind == MeasurementKind::kRestitution ? restitutions(values, at)
                                                             : responses(values, at);
}

// Without clamping: clamped values do not depend on the coefficients.
std::optional<Vector> FitModel::restitutions(const Vector& values, const Vector& speeds) const {
  std::vector<double> list = coefficients(scene_);
  for (std::size_t j = 0; j < parameters_.size(); ++j)
    list[parameters_[j].coefficient] = values[static_cast<Eigen::Index>(j)];
  const Restitution law(list);
  return speeds.unaryExpr([&](double v) { return law.unclamped(v); });
}

std::optional<Matrix> FitModel::derivative() const {
  if (measurements_.kind != MeasurementKind::kRestitution) return {};
  const Vector& v = measurements_.at;
  Matrix columns(v.size(), static_cast<Eigen::Index>(parameters_.size()));
  for (std::size_t j = 0; j < parameters_.size(); ++j) {
    const auto power = static_cast<double>(parameters_[j].coefficient);
    columns.col(static_cast<Eigen::Index>(j)) =
        power == 0.0 ? Vector(Vector::Ones(v.size())) : Vector(-v.array().pow(power));
  }
  return columns;
}

const System* FitModel::system_at(const Vector& values, State& start) {
  std::vector<double> of_scene;
  record_start_ = 0.0;
  for (std::size_t j = 0; j < parameters_.size(); ++j) {
    const double value = values[static_cast<Eigen::Index>(j)];
    switch (parameters_[j].target) {
      case Target::kScene:
        of_scene.push_back(value);
        break;
      case Target::kClock:
        record_start_ = value;
        break;
      case Target::kInitialState:
        start_coordinate(scene_, parameters_[j].name) = value;
        break;
    }
  }
  const System* system = cursor_->at(of_scene);
  if (system == nullptr) {
    why_ = "the scene does not allow these values";
    return nullptr;
  }
  // What a start in the structure's own coordinates is in the modes depends on the structure there.
  Scene there = cursor_->scene();
  there.initial = scene_.initial;
  const std::optional<State> clear = clear_start(there, *system);
  if (!clear) {
    why_ = "the motion would start beyond a stop";
    return nullptr;
  }
  start = *clear;
  return system;
}

bool FitModel::follow(const System& system, const State& start, Observation& observation) {
  observation.closure_speed = options_.closure_speed.value_or(
      default_closure_speed(system, start, scene_.solver.tolerance));
  observation.max_impacts = options_.max_impacts > 0 ? options_.max_impacts : kDefaultImpactBudget;
  observation.stop = options_.stop;
  why_ = observe(system, start, observation);
  return why_.empty();
}

double FitModel::quantity(const MeasuredSeries& series, const System& system,
                          const Observed& observed, const std::vector<ProbeRow>& probes) const {
  // On a hub the coordinates are still those of the beam.
  const auto coordinate = [&](const Vector& q) {
    return system.turns() ? system.rotation()->beam.row(series.index).dot(q) : q[series.index];
  };
  if (series.quantity == Quantity::kProbe)
    return probes[static_cast<std::size_t>(series.index)].value({observed.q, observed.qdot});
  if (series.quantity == Quantity::kCoordinate) return coordinate(observed.q);
  if (series.quantity == Quantity::kRate) return coordinate(observed.qdot);
  if (series.quantity == Quantity::kForce) return observed.forces[series.index];
  const auto i = static_cast<std::size_t>(series.index);
  const Stop& stop = system.stops[i];
  // Sign of u: the row points into the stop.
  const double way = scene_.stops[i].side == Side::kAbove ? 1.0 : -1.0;
  const double towards = stop.row.dot(observed.q);
  switch (series.quantity) {
    case Quantity::kGap:
      return stop.gap - towards;
    case Quantity::kPenetration:
      return std::max(towards - stop.gap, 0.0);
    case Quantity::kDisplacement:
      return way * towards;
    default:
      return way * stop.row.dot(observed.qdot);
  }
}

std::optional<Vector> FitModel::responses(const Vector& values, const Vector& at) {
  State start;
  const System* system = system_at(values, start);
  if (system == nullptr) return {};
  const Eigen::Index rows = at.size();
  Vector predicted(rows * static_cast<Eigen::Index>(measurements_.series.size()));
  Observation observation;
  for (const double time : at) observation.times.push_back(time + record_start_);
  if (observation.times.front() < 0.0) {
    why_ = "the record would begin before the motion does";
    return {};
  }
  observation.end = observation.times.back();
  std::vector<ProbeRow> probes;
  for (const MeasuredSeries& series : measurements_.series) {
    observation.forces = observation.forces || series.quantity == Quantity::kForce;
    if (series.quantity == Quantity::kProbe && probes.empty())
      probes = probe_rows(scene_at(values), *system);
  }
  observation.state = [&](const Observed& observed) {
    auto place = static_cast<Eigen::Index>(observed.index);
    for (const MeasuredSeries& series : measurements_.series) {
      predicted[place] = quantity(series, *system, observed, probes);
      place += rows;
    }
  };
  if (!follow(*system, start, observation)) return {};
  if (predicted.allFinite()) return predicted;
  why_ = "the motion left the range of double precision";
  return {};
}

std::optional<Vector> FitModel::impact_times(const Vector& values) {
  State start;
  const System* system = system_at(values, start);
  if (system == nullptr) return {};
  const Vector& measured = measurements_.series[0].values;
  std::map<int, std::vector<Eigen::Index>>
      wanted;  // rows by stop, those asked for first at the end
  for (auto i = static_cast<Eigen::Index>(measurements_.rows()); i-- > 0;)
    wanted[measurements_.stops[static_cast<std::size_t>(i)]].push_back(i);
  Observation observation;
  observation.end = kLonger * measured.maxCoeff() + std::max(record_start_, 0.0);
  Vector predicted = Vector::Constant(measured.size(), observation.end - record_start_);
  missing_ = measurements_.rows();
  observation.impact = [&](int stop, double time) {
    // Impacts before the start of the record are not recorded.
    if (time < record_start_) return true;
    auto rows = wanted.find(wanted.count(stop) ? stop : -1);
    if (rows == wanted.end() || rows->second.empty()) return true;
    predicted[rows->second.back()] = time - record_start_;
    rows->second.pop_back();
    return --missing_ > 0;
  };
  if (!follow(*system, start, observation)) return {};
  if (missing_ > 0)
    why_ = fmt::format("of {} measured impacts the motion has {} up to {:.6g}{}",
                       measurements_.rows(), measurements_.rows() - missing_, observation.end,
                       unit_behind(system->units, "s"));
  return predicted;
}

Scene FitModel::scene_at(const Vector& values) const {
  Scene scene = scene_;
  const std::shared_ptr<const Origins> origins = scene.origins;
  scene.origins = nullptr;  // the values are not those in the file
  for (std::size_t j = 0; j < parameters_.size(); ++j) {
    const double value = values[static_cast<Eigen::Index>(j)];
    if (parameters_[j].target == Target::kScene)
      set_parameter(scene, parameters_[j].name, value);
    else if (parameters_[j].target == Target::kInitialState)
      start_coordinate(scene, parameters_[j].name) = value;
  }
  check_scene(scene);
  scene.origins = origins;
  return scene;
}

}  // namespace graze
