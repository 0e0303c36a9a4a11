// The phase of a structure that closed stops hold so that its modes do not decouple.
#pragma once

#include "graze/flow/held/detail/exact_phase.hpp"

namespace graze {

class CoupledPhase final : public ExactPhase<double> {
 public:
  using ContactPhase<double>::start;
  // `equations` are those of the structure (couple()).
  CoupledPhase(const System& system, PhaseKey key, ConstrainedStructure<double> structure,
               const CoupledSystem& equations);

  std::string refusal() const override { return flow_.instability(); }
  void start(const double& theta, const Vector& q, const Vector& qdot, const double& time) override;
  void state(const double& s, Vector& q, Vector& qdot) const override;
  const CoupledArc* coupled_arc() const override { return &arc_; }

 private:
  double longest_flight() const override { return flow_.longest_flight(); }
  bool set_curve(ArcCurve<double>& curve, const Observable<double>& observable,
                 const double& window, bool from_zero) const override;
  double start_phase() const override { return arc_.start_phase(); }

  CoupledFlow flow_;
  CoupledArc arc_;
};

}  // namespace graze
