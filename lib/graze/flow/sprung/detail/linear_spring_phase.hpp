// The phase of a structure that compresses linear springs, with dashpots or without: while the same
// springs act it is a linear structure with other modes, and it is treated like one whose modes are
// coupled by closed stops. The ends of contacts are zeros of depths and forces, found and certified
// like contacts.
#pragma once

#include <vector>

#include "graze/flow/held/detail/coupled_phase.hpp"
#include "graze/flow/sprung/detail/spring_arc.hpp"

namespace graze {

// Largest number of modes that is decomposed, which takes some (2 N)^3 times 1e-8 s; with more,
// contacts are integrated.
inline constexpr int kMostModesOnLinearSprings = 128;

// Whether all springs of the phase are linear and the modes not too many.
bool suits_linear_springs(const System& system, const PhaseKey& key);

class LinearSpringPhase final : public CoupledPhase {
 public:
  using ContactPhase<double>::start;
  LinearSpringPhase(const System& system, const PhaseKey& key);

  void start(const double& theta, const Vector& q, const Vector& qdot, const double& time) override;
  Arrival<double> first_event(const MotionState<double>& now,
                              const Flight<double>& flight) override;
  // Computed from the forces: in the modal form rounding grows with each derivative.
  CurvePoint<double> gap_rate(int stop, int order) const override;
  const SpringArc* sprung() const override { return &spring_arc_; }

 private:
  LinearSpringPhase(const System& system, const PhaseKey& key, SprungEquations given);
  Vector load_at(const Vector& y) const;
  void look_at_spring(std::size_t k, const MotionState<double>& now, const Flight<double>& flight,
                      Arrival<double>& arrival) const;

  SprungSystem equations_;
  std::vector<int> stops_;    // that the springs are of
  std::vector<Vector> rows_;  // of the springs
  std::vector<double> gaps_, depths_;
  std::vector<Vector> stop_rows_;  // of every stop
  double theta_ = 0.0;             // at the start
  Vector q_, qdot_;
  SpringArc spring_arc_;
};

}  // namespace graze
