// The phase of a structure whose modes do not decouple because of closed stops, of damping or of
// springs (linear_spring_phase.hpp).
#pragma once

#include <algorithm>

#include "graze/flow/held/detail/exact_phase.hpp"

namespace graze {

class CoupledPhase : public ExactPhase<double> {
 public:
  using ContactPhase<double>::start;
  // `equations` are those of the structure (couple()).
  CoupledPhase(const System& system, PhaseKey key, ConstrainedStructure<double> structure,
               const CoupledSystem& equations);

  // Damping takes energy; growth can only come from an oblique law, or from friction at springs.
  std::string refusal() const override {
    const std::vector<Contact>& frictions = this->key().frictions;
    const bool slides = std::any_of(frictions.begin(), frictions.end(), [](Contact c) {
      return c == Contact::kForward || c == Contact::kBackward;
    });
    return structure().constrained.empty() || slides ? std::string() : flow_.instability();
  }
  void start(const double& theta, const Vector& q, const Vector& qdot, const double& time) override;
  void state(const double& s, Vector& q, Vector& qdot) const override;
  const CoupledArc* coupled_arc() const override { return &arc_; }

 protected:
  // With given observables of every stop and friction, instead of the structure's own.
  CoupledPhase(const System& system, PhaseKey key, ConstrainedStructure<double> structure,
               std::vector<Observable<double>> observables, const CoupledSystem& equations);
  const CoupledFlow& flow() const { return flow_; }
  CoupledArc& coupled_motion() { return arc_; }

 private:
  double longest_flight() const override { return flow_.longest_flight(); }
  bool set_curve(ArcCurve<double>& curve, const Observable<double>& observable,
                 const double& window, bool from_zero) const override;
  double start_phase() const override { return arc_.start_phase(); }

  CoupledFlow flow_;
  CoupledArc arc_;
};

}  // namespace graze
