// The model of measurements as a function of the fitted parameters: the restitution r(v) = a0 - a1
// v - .. in closed form, or a motion evaluated where it was measured.
//
// For measured motions there are, besides the parameters of the scene,
//   record.start            the time of the scene, s, at which the clock of the record reads zero
//   initial.q.1, initial.qdot.1 ..   the state in which the motion starts (kg^1/2 m, kg^1/2 m/s)
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graze/assembly/probes.hpp"
#include "graze/assembly/system_family.hpp"
#include "graze/base/stop_signal.hpp"
#include "graze/fit/detail/observed_motion.hpp"
#include "graze/fit/measurements.hpp"

namespace graze {

inline constexpr const char* kRecordStart = "record.start";

struct FitModelOptions {
  std::optional<double> closure_speed;  // m/s; absent: default_closure_speed at each value
  long long max_impacts = 0;            // of one motion
  StopSignal stop;
};

// Why a motion cannot be evaluated at some values of the parameters.
struct ModelFailure {
  std::string sentence;
};

class FitModel {
 public:
  // Throws InputError where the scene has no such parameter or `measurements` do not depend on it.
  FitModel(const Scene& scene, const Measurements& measurements,
           const std::vector<std::string>& parameters, const FitModelOptions& options);
  FitModel(const FitModel&) = delete;
  FitModel& operator=(const FitModel&) = delete;

  // The scene's own values, and their SI units.
  const Vector& start() const { return start_; }
  const std::vector<std::string>& units() const { return units_; }
  Units scene_units() const { return scene_.units; }

  // The model's prediction of the measurements at these values: all series one after the other,
  // each in the order of its rows, SI. Returns nullopt when the scene does not allow the values or
  // the motion cannot be followed; why() then gives the reason.
  std::optional<Vector> predict(const Vector& values);
  const std::string& why() const { return why_; }
  // The derivative of the prediction, one column a parameter; nullopt when it has no closed form.
  std::optional<Matrix> derivative() const;

  // For a motion with fewer impacts than were measured: how many are missing at the latest values.
  // A missing impact counts as one at the end of the time that the motion is followed.
  std::size_t missing_impacts() const { return missing_; }

  // Series as above at other places than those measured (no impact times): times or speeds.
  std::optional<Vector> predict_at(const Vector& values, const Vector& at);

  // The scene with these values. record.start is not one of its numbers.
  Scene scene_at(const Vector& values) const;

 private:
  // What a fitted value sets.
  enum class Target { kScene, kClock, kInitialState };
  struct Parameter {
    std::string name;
    Target target = Target::kScene;
    std::size_t coefficient = 0;  // of a restitution, its power
  };

  void add(const std::string& name);
  void check_restitution(const std::string& name) const;
  std::optional<Vector> restitutions(const Vector& values, const Vector& speeds) const;
  std::optional<Vector> responses(const Vector& values, const Vector& at);
  std::optional<Vector> impact_times(const Vector& values);
  // The system at these values, with its start; null, with why_ set, when there is none.
  const System* system_at(const Vector& values, State& start);
  bool follow(const System& system, const State& start, Observation& observation);
  double quantity(const MeasuredSeries& series, const System& system, const Observed& observed,
                  const std::vector<ProbeRow>& probes) const;

  Scene scene_;  // with the initial state in force
  const Measurements& measurements_;
  FitModelOptions options_;
  std::vector<Parameter> parameters_;
  Vector start_;
  std::vector<std::string> units_;
  std::unique_ptr<SystemCursor> cursor_;
  double record_start_ = 0.0;  // s, at the values asked for last
  std::size_t missing_ = 0;
  std::string why_;
};

}  // namespace graze
