#include "graze/flow/sprung/detail/spring_arc.hpp"

#include <limits>

#include "graze/system/detail/gap_value.hpp"

namespace graze {
namespace {

Vector or_zero(const Vector& list, Eigen::Index n) {
  return list.size() > 0 ? list : Vector(Vector::Zero(n));
}

// What closed stops leave of a spring's row. Where they hold its depth that is nothing; its
// rounding would be taken for a contact with hardly any mobility, and the units of the contact from
// it.
Vector left_of_row(const ConstrainedStructure<double>& structure, const Vector& row) {
  constexpr double kRoundings = 16.0;
  Vector left = structure.rates(row);
  const double rounding = kRoundings * std::numeric_limits<double>::epsilon() *
                          static_cast<double>(row.size()) * row.norm();
  if (!structure.is_free() && left.norm() <= rounding) left.setZero();
  return left;
}

}  // namespace

Observable<double> linear_force(const ContactForce& law, const Observable<double>& depth) {
  Observable<double> force{law.stiffness * depth.constant,
                           law.stiffness * depth.displacement,
                           {},
                           {law.stiffness * depth.harmonic.re, law.stiffness * depth.harmonic.im}};
  if (law.damping != ContactDamping::kNone) force.velocity = law.coefficient * depth.displacement;
  return force;
}

// The reduced motion with its springs, on the displacements themselves.
SprungEquations sprung_equations(const System& system, const PhaseKey& key) {
  SprungEquations equations{ConstrainedStructure<double>(system, key.closed), {}};
  SprungSystem& sprung = equations.system;
  if (equations.structure.has_real_modes) {
    const LinearSystem<double>& modes = equations.structure.reduced;
    sprung.stiffness = modes.omega.cwiseAbs2();
    sprung.damping = 2.0 * modes.delta;
    sprung.load = or_zero(modes.load, modes.omega.size());
    sprung.force = or_zero(modes.amplitude, modes.omega.size());
    sprung.frequency = modes.forced ? modes.frequency : 0.0;
  } else {
    CoupledSystem coupled = couple(equations.structure);
    equations.refusal = CoupledFlow(coupled).instability();
    sprung.stiffness = std::move(coupled.stiffness);
    sprung.damping = std::move(coupled.damping);
    sprung.load = std::move(coupled.load);
    sprung.force = std::move(coupled.force);
    sprung.frequency = coupled.frequency;
  }
  add_springs(system, key, equations.structure, sprung);
  return equations;
}

void add_springs(const System& system, const PhaseKey& key,
                 const ConstrainedStructure<double>& structure, SprungSystem& equations) {
  const auto add = [&](const std::vector<int>& stops, bool loaded) {
    for (const int i : stops) {
      const Stop& stop = system.stops[static_cast<std::size_t>(i)];
      const Vector row = left_of_row(structure, stop.row);
      const Vector acting = structure.left.size() > 0 ? Vector(structure.left * stop.row) : row;
      equations.springs.push_back({stop.force(), row, acting, loaded, stop.row});
    }
  };
  add(key.springs.loaded, true);
  add(key.springs.parted, false);
}

int depth_multiplicity(const Vector& row, const Vector& qdot, double push) {
  if (row.dot(qdot) > speed_rounding<double>(row, qdot)) return 1;
  return push > 0.0 ? 2 : 3;
}

int left_at_once(const std::vector<Vector>& rows, const std::vector<double>& depths,
                 const Vector& qdot) {
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (!(depths[k] > 0.0) && rows[k].dot(qdot) < -speed_rounding<double>(rows[k], qdot))
      return static_cast<int>(k);
  return -1;
}

}  // namespace graze
