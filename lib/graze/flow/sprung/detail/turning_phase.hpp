// The phase of a structure on a rotating hub, with springs or without.
#pragma once

#include "graze/flow/sprung/detail/sprung_phase.hpp"

namespace graze {

class TurningPhase final : public SprungPhase {
 public:
  using ContactPhase<double>::start;
  // `angle`: where the joint is held, rad. It is then closed like a stop, but holds either way; its
  // torque is force_at() of the stop index system.stops.size().
  TurningPhase(const System& system, const PhaseKey& key, const std::optional<StepSetting>& steps,
               double angle);

  void start(const double& theta, const Vector& q, const Vector& qdot, const double& time) override;
  double force_at(int stop, const double& s, const Vector& q, const Vector& qdot) const override;
  double force_rate(int stop) const override;

 private:
  // `holding`: the system, with a held joint added as a stop.
  TurningPhase(const System& holding, const PhaseKey& key, const std::optional<StepSetting>& steps);
  static SprungEquations equations_of(const System& holding, const PhaseKey& key);
  double longest_flight() const override { return turning().structure.smooth_for(); }
  ForcesAtStart at_start() const override;
  void watch_joint(const MotionState<double>& now, std::vector<Watched>& list) override;
  const Turning& turning() const { return *SprungPhase::equations().turning; }

  // For a sliding joint: its rate in the direction of rotation, up to where it stops. For a held
  // joint: the margin of the friction against being turned forward and back.
  std::vector<Watch> joint_watches_;
};

}  // namespace graze
