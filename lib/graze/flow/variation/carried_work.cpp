#include "graze/flow/variation/detail/carried_work.hpp"

#include "graze/flow/held/detail/structure_forms.hpp"
#include "graze/flow/sprung/detail/spring_arc.hpp"
#include "graze/flow/variation/detail/signal.hpp"

namespace graze {
void add_carried_work(const System& system, const ExactPhase<double>& phase, double s, Work& work) {
  const CoupledArc& arc = *phase.coupled_arc();
  const Moments moments = moments_along(arc, s);
  const StructureForms forms = structure_forms(system, phase.structure());
  const Eigen::Index n = system.modes(), m = phase.structure().size();
  const Vector scale = arc.flow().scale().cwiseInverse();
  // On z = (scale (y - origin), y', u cos, u sin, u).
  const auto on_moments = [&](const Matrix& place, const Matrix& rate, const Vector& cosine) {
    Matrix form = Matrix::Zero(n, 2 * m + 3);
    form.leftCols(m) = place * scale.asDiagonal();
    form.middleCols(m, m) = rate;
    form.col(2 * m) = cosine / moments.unit;
    form.col(2 * m + 2) = place * arc.origin() / moments.unit;
    return form;
  };
  const Matrix velocity = on_moments(forms.place, forms.rate, Vector::Zero(n));
  const Matrix force = on_moments(forms.force_place, forms.force_rate, forms.forcing);
  const Matrix of_velocity = velocity * moments.integral;
  work.forcing += of_velocity.cwiseProduct(force).sum();
  work.dissipation += (of_velocity * velocity.transpose()).cwiseProduct(system.damping()).sum();
  for (const int i : phase.closed()) {
    const Stop& stop = system.stops[static_cast<std::size_t>(i)];
    const Vector weight =
        weights_of(phase.observables()[static_cast<std::size_t>(i)], arc, moments);
    // A contact force of 1 N accelerates by -direction |row|^2.
    work.stops -= stop.row.squaredNorm() * stop.direction().dot(of_velocity * weight);
  }
  const SpringArc* springs = phase.sprung();
  if (!springs) return;
  const std::vector<int>& loaded = springs->springs().loaded;
  for (std::size_t k = 0; k < loaded.size(); ++k) {
    const Observable<double>& depth = springs->depth_observables[k];
    const Vector weight =
        weights_of(linear_force(springs->equations.springs[k].law, depth), arc, moments);
    Vector relative = Vector::Zero(2 * m + 3);
    relative.segment(m, m) = depth.displacement;
    const Vector& row = system.stops[static_cast<std::size_t>(loaded[k])].row;
    work.stops -= (velocity.transpose() * row - relative).dot(moments.integral * weight);
  }
}

void add_carried_jump(const System& system, double theta, const State& before, const State& after,
                      Work& work) {
  const State none{Vector::Zero(system.modes()), Vector::Zero(system.modes())};
  const State carried = structure_state(system, none, theta);
  work.stops += carried.qdot.dot(after.qdot - before.qdot) +
                carried.q.dot(system.omega.cwiseAbs2().cwiseProduct(after.q - before.q));
}

}  // namespace graze
