#include "graze/flow/held/detail/structure_forms.hpp"

namespace graze {
namespace {

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
    const std::size_t k = structure.harmonic_of(one.order);
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

}  // namespace graze
