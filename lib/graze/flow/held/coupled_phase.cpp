#include "graze/flow/held/detail/coupled_phase.hpp"

#include "graze/flow/held/detail/held_exactly.hpp"

namespace graze {

CoupledPhase::CoupledPhase(const System& system, PhaseKey key,
                           ConstrainedStructure<double> structure, const CoupledSystem& equations)
    : ExactPhase(system, std::move(key), std::move(structure)), flow_(equations), arc_(flow_) {}

CoupledPhase::CoupledPhase(const System& system, PhaseKey key,
                           ConstrainedStructure<double> structure,
                           std::vector<Observable<double>> observables,
                           const CoupledSystem& equations)
    : ExactPhase(system, std::move(key), std::move(structure), std::move(observables)),
      flow_(equations),
      arc_(flow_) {}

void CoupledPhase::start(const double& theta, const Vector& q, const Vector& qdot,
                         const double& /*time*/) {
  forget_curves();
  arc_.start(theta, structure().coordinates(q, theta), structure().rates(qdot, theta));
}

void CoupledPhase::state(const double& s, Vector& q, Vector& qdot) const {
  Vector y, ydot;
  arc_.state(s, y, ydot);
  q = structure().displacements(y);
  qdot = structure().velocities(ydot);
}

// Its matrix exponentials depend on the window.
bool CoupledPhase::set_curve(ArcCurve<double>& curve, const Observable<double>& observable,
                             const double& window, bool from_zero) const {
  curve = arc_.curve(observable, window, from_zero);
  return false;
}

std::unique_ptr<ExactPhase<double>> exact_phase(const System& system, const PhaseKey& key) {
  if (key.closed.empty() && system.has_closed_forms())
    return std::make_unique<FreePhase<double>>(system, key);
  ConstrainedStructure<double> structure(system, key.closed, key.places);
  if (structure.has_real_modes)
    return std::make_unique<ConstrainedPhase<double>>(system, key, std::move(structure));
  const CoupledSystem equations = couple(structure);
  return std::make_unique<CoupledPhase>(system, key, std::move(structure), equations);
}

}  // namespace graze
