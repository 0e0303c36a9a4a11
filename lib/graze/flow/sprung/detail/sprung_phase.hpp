// The phase of a structure that compresses springs, followed step by step, by series or integrated;
// events are searched for also between the ends of its steps (step_walk.hpp).
#pragma once

#include <limits>
#include <vector>

#include "graze/flow/sprung/detail/spring_arc.hpp"
#include "graze/flow/stepped/detail/stepped_phase.hpp"

namespace graze {

// Tolerance of a step where the motion has no closed form, against the speed of the contact
// (sprung_rates.hpp), or of the rotating structure. By series a contact returns the speed to some
// roundings, by extrapolation, with some thousand evaluations, to 3e-13; over some ten thousand
// steps the energy keeps ten digits.
inline constexpr double kStepTolerance = 1e-14;

class SprungPhase : public IntegratedPhase {
 public:
  using ContactPhase<double>::start;
  // `steps`: uses the scene's method in place of the one that suits contacts.
  SprungPhase(const System& system, const PhaseKey& key, const std::optional<StepSetting>& steps);

  const ConstrainedStructure<double>& structure() const final { return structure_; }
  std::string refusal() const final { return refusal_; }
  const SprungSystem& equations() const { return equations_; }

  void start(const double& theta, const Vector& q, const Vector& qdot, const double& time) override;
  CurvePoint<double> gap_rate(int stop, int order) const final;
  double force_at(int stop, const double& s, const Vector& q, const Vector& qdot) const override;
  double force_rate(int stop) const override;
  const SpringArc* sprung() const final { return &spring_arc_; }

 protected:
  // For derived classes; integrate() completes the construction.
  SprungPhase(const System& system, const PhaseKey& key, SprungEquations equations);
  // To be called last: the integrator keeps copies.
  void integrate(const std::optional<StepSetting>& steps);
  SprungSystem& equations() { return equations_; }

  virtual ForcesAtStart at_start() const;
  // The forces of loaded springs, on all coordinates, N.
  Vector spring_push(const Vector& q, const Vector& qdot) const;
  const std::vector<double>& depths() const { return depths_; }
  const Vector& start_q() const { return q_; }
  const Vector& start_qdot() const { return qdot_; }

 private:
  void add_force_weights(const System& system);
  void add_powers(const System& system);
  void add_moving(const System& system);
  Vector force(double s, const Vector& q, const Vector& qdot) const;
  void watch_springs(const MotionState<double>& now, const Flight<double>& flight,
                     std::vector<Watched>& list) final;
  std::optional<Arrival<double>> left_at_once(const MotionState<double>& now) const final;

  ConstrainedStructure<double> structure_;
  SprungSystem equations_;
  std::string refusal_;
  std::vector<int> springs_;                         // the stops that they are of
  std::vector<Vector> rows_, spring_rows_;           // of every stop; of the springs
  std::vector<double> gaps_;                         // of every stop, m
  std::vector<Watch> depth_watches_, grip_watches_;  // of every spring
  std::vector<double> depths_;
  double theta_ = 0.0;
  Vector q_, qdot_;
  SpringArc spring_arc_{key(), structure_, equations_, depths_};
};

}  // namespace graze
