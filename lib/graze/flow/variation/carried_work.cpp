#include "graze/flow/variation/detail/carried_work.hpp"

#include "graze/flow/sprung/detail/spring_arc.hpp"
#include "graze/flow/variation/detail/signal.hpp"

namespace graze {
namespace {

// The harmonic of the force that has the order of another.
std::size_t harmonic_of(const ConstrainedStructure<double>& structure, double order) {
  std::size_t k = 0;
  while (structure.whole.harmonics[k].timed || structure.whole.harmonics[k].order != order) ++k;
  return k;
}

// Adds cosine cos + sine sin of the drive z = unit cos(k theta), z' = -rate_unit sin(k theta).
void add_harmonic(const ConstrainedStructure<double>& structure, std::size_t k,
                  const Vector& cosine, const Vector& sine, Matrix& place, Matrix& rate) {
  place.col(structure.drive(k)) += cosine / structure.units[k];
  rate.col(structure.drive(k)) -= sine / structure.rate_unit(k);
}

}  // namespace

StructureForms structure_forms(const System& system,
                               const ConstrainedStructure<double>& structure) {
  const Eigen::Index n = system.modes(), m = structure.size();
  StructureForms forms{Matrix::Zero(n, m), structure.basis, system.forcing()->amplitude,
                       Matrix::Zero(n, m), Matrix::Zero(n, m)};
  for (std::size_t k = 0; k < system.harmonics()->size(); ++k)
    add_harmonic(structure, k, (*system.harmonics())[k].cosine, (*system.harmonics())[k].sine,
                 forms.force_place, forms.force_rate);
  for (const Harmonic& one : *system.carried()) {
    const std::size_t k = harmonic_of(structure, one.order);
    const double frequency = one.order * structure.whole.frequency;
    add_harmonic(structure, k, frequency * one.sine, -frequency * one.cosine, forms.place,
                 forms.rate);
    // The system's force lacks c'' + D c' + w^2 c, which the loads have.
    const Vector stiffness = (system.omega.array().square() - frequency * frequency).matrix();
    add_harmonic(
        structure, k,
        stiffness.cwiseProduct(one.cosine) + frequency * system.resistance(one.sine),
        stiffness.cwiseProduct(one.sine) - frequency * system.resistance(one.cosine),
        forms.force_place, forms.force_rate);
  }
  return forms;
}

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
  if (!system.carried()) return;
  const State none{Vector::Zero(system.modes()), Vector::Zero(system.modes())};
  const State carried = structure_state(system, none, theta);
  work.stops += carried.qdot.dot(after.qdot - before.qdot) +
                carried.q.dot(system.omega.cwiseAbs2().cwiseProduct(after.q - before.q));
}

}  // namespace graze
