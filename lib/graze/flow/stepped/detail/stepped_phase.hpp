// Phases that are integrated step by step: events are looked for at the ends of the steps.
#pragma once

#include <memory>
#include <vector>

#include "graze/flow/held/detail/exact_phase.hpp"
#include "graze/flow/stepped/detail/step_flow.hpp"
#include "graze/flow/stepped/step_setting.hpp"

namespace graze {

// Common base: the state on the coordinates that are left free, x = (scale y, y'), and the watches
// at the stops.
class IntegratedPhase : public ContactPhase<double> {
 public:
  using ContactPhase<double>::start;
  StepFlow& steps() const { return *steps_; }
  StepFlow* stepped() const final { return steps_.get(); }
  virtual const ConstrainedStructure<double>& structure() const = 0;
  void state(const double& s, Vector& q, Vector& qdot) const override;
  Arrival<double> first_event(const MotionState<double>& now,
                              const Flight<double>& flight) override;
  long long evaluations() const override { return steps_->evaluations(); }
  double force_error(int stop) const override {
    return force_errors_[static_cast<std::size_t>(stop)];
  }

 protected:
  struct Watched {
    int stop = -1;  // -1: the joint of a hub
    const Watch* watch = nullptr;
    ArrivalKind kind = ArrivalKind::kContact;
    bool below = false;
  };

  using ContactPhase<double>::ContactPhase;
  // Both are called before the first start; for every stop, the gap or, if closed, its contact
  // force.
  void watch(const std::vector<Observable<double>>& observables, Vector scale);
  void step_by(std::unique_ptr<StepFlow> steps) { steps_ = std::move(steps); }
  std::vector<Watch>& watches() { return watches_; }
  void start_steps(double theta, const Vector& q, const Vector& qdot,
                   std::span<const double> depths = {}, double time = 0.0);

 private:
  // Adds further watches, before those of the stops, and after them.
  virtual void watch_springs(const MotionState<double>& /*now*/, const Flight<double>& /*flight*/,
                             std::vector<Watched>& /*list*/) {}
  virtual void watch_joint(const MotionState<double>& /*now*/, std::vector<Watched>& /*list*/) {}
  // A spring that is left at the instant of the start itself.
  virtual std::optional<Arrival<double>> left_at_once(const MotionState<double>& /*now*/) const {
    return {};
  }
  const Watch& watch_of(int stop, Contact at, int multiplicity, double sure);
  void tell(const std::vector<Watched>& list, const StepDescent& found, Arrival<double>& arrival);

  Vector scale_;
  std::vector<Watch> watches_;
  std::vector<double> force_errors_;  // of every stop, N
  std::unique_ptr<StepFlow> steps_;
};

// Replaces the exact flow, whose closed form at the start still decides how a stop is left.
class SteppedPhase final : public IntegratedPhase {
 public:
  SteppedPhase(std::unique_ptr<ExactPhase<double>> exact, const StepSetting& setting);

  const ConstrainedStructure<double>& structure() const override { return exact_->structure(); }
  std::string refusal() const override { return exact_->refusal(); }
  void start(const double& theta, const Vector& q, const Vector& qdot, const double& time) override;
  CurvePoint<double> gap_rate(int stop, int order) const override {
    return exact_->gap_rate(stop, order);
  }
  double force_at(int stop, const double& s, const Vector& q, const Vector& qdot) const override {
    return exact_->force_at(stop, s, q, qdot);
  }
  double force_rate(int stop) const override { return exact_->force_rate(stop); }
  bool sees_ahead() const override { return true; }
  CurvePoint<double> outlook(int stop, int order, const double& ahead) const override {
    return exact_->outlook(stop, order, ahead);
  }
  bool stays_quiet(int stop, const double& duration) const override {
    return exact_->stays_quiet(stop, duration);
  }
  const ExactPhase<double>* exact() const override { return exact_.get(); }

 private:
  double longest_flight() const override;

  std::unique_ptr<ExactPhase<double>> exact_;
};

}  // namespace graze
