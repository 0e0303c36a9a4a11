#include "graze/flow/sprung/detail/spring_arc.hpp"

#include <cmath>
#include <limits>

#include "graze/flow/held/detail/contact_share.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {
namespace {

Vector or_zero(const Vector& list, Eigen::Index n) {
  return list.size() > 0 ? list : Vector(Vector::Zero(n));
}

// The part of a spring's row that closed stops leave free. Where they hold its depth that is zero;
// its rounding would otherwise look like a contact with hardly any mobility and set the units of
// the contact.
Vector left_of_row(const ConstrainedStructure<double>& structure, const Vector& row) {
  constexpr double kRoundings = 16.0;
  Vector left = structure.seen(row);
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
  SprungEquations equations{ConstrainedStructure<double>(system, key.closed, key.places), {}};
  SprungSystem& sprung = equations.system;
  ConstrainedStructure<double>& structure = equations.structure;
  // What friction holds in all coordinates keeps one, as on a belt that stands still.
  if (structure.size() == 0 && !system.frictions.empty()) {
    structure.drift = structure.rows.col(0);
    structure.has_real_modes = false;
  }
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
  const auto add = [&](const std::vector<int>& stops, bool loaded, bool resting) {
    for (const int i : stops) {
      const Stop& stop = system.stops[static_cast<std::size_t>(i)];
      const Vector row = left_of_row(structure, stop.row);
      const Vector pushing = pushing_row(system, i, key.frictions);
      Vector acting = structure.left.size() > 0 ? Vector(structure.left * pushing)
                      : pushing == stop.row     ? row
                                                : structure.seen(pushing);
      // Nothing moves what a belt carries along.
      if (structure.drift.size() > 0)
        acting[structure.size() - 1 - static_cast<Eigen::Index>(structure.units.size())] = 0.0;
      equations.springs.push_back({stop.force(), row, acting, loaded, stop.row, resting, pushing});
    }
  };
  add(key.springs.loaded, true, false);
  add(key.springs.parted, false, false);
  add(key.springs.resting, false, true);
}

Vector spring_push(const SprungSystem& equations, const std::vector<double>& depths,
                   const Vector& qdot) {
  Vector push = Vector::Zero(qdot.size());
  for (std::size_t k = 0; k < depths.size(); ++k) {
    const SprungSystem::Spring& spring = equations.springs[k];
    if (spring.loaded)
      push += spring.law.at(depths[k], spring.whole_row.dot(qdot)) * spring.pushing;
  }
  return push;
}

Vector spring_push_rate(const SprungSystem& equations, const std::vector<double>& depths,
                        const Vector& qdot, const Vector& acceleration) {
  Vector push = Vector::Zero(qdot.size());
  for (std::size_t k = 0; k < depths.size(); ++k) {
    const SprungSystem::Spring& spring = equations.springs[k];
    if (!spring.loaded) continue;
    const double rate = spring.whole_row.dot(qdot);
    push += (spring.law.by_depth(depths[k], rate) * rate +
             spring.law.by_rate(depths[k], rate) * spring.whole_row.dot(acceleration)) *
            spring.pushing;
  }
  return push;
}

ForcesAtStart forces_at_start(const ConstrainedStructure<double>& structure,
                              const SprungSystem& equations, const std::vector<double>& depths,
                              double theta, const Vector& q, const Vector& qdot) {
  const LinearSystem<double>& free = structure.whole;
  const Vector stiffness = free.omega.cwiseAbs2();
  // The part of an acceleration that closed stops allow.
  const auto held_back = [&](const Vector& acceleration) -> Vector {
    if (structure.constrained.empty()) return acceleration;
    return acceleration - structure.directions * (structure.shares.transpose() * acceleration);
  };
  const auto resistance = [&](const Vector& velocity) -> Vector {
    Vector force = 2.0 * free.delta.cwiseProduct(velocity);
    if (free.coupling.size() > 0) force += free.coupling * velocity;
    return force;
  };
  const auto resistance_size = [&](const Vector& velocity) -> Vector {
    Vector size = 2.0 * free.delta.cwiseProduct(velocity.cwiseAbs());
    if (free.coupling.size() > 0) size += free.coupling.cwiseAbs() * velocity.cwiseAbs();
    return size;
  };
  const Vector push = spring_push(equations, depths, qdot);
  ForcesAtStart at;
  at.force = -resistance(qdot) - stiffness.cwiseProduct(q) - push;
  at.size = resistance_size(qdot) + stiffness.cwiseProduct(q.cwiseAbs()) + push.cwiseAbs();
  if (free.load.size() > 0) {
    at.force += free.load;
    at.size += free.load.cwiseAbs();
  }
  if (free.forced) {
    at.force += free.forces(theta);
    at.size += free.force_sizes();
  }
  at.acceleration = held_back(at.force);
  const Vector push_rate = spring_push_rate(equations, depths, qdot, at.acceleration);
  at.force_rate = -resistance(at.acceleration) - stiffness.cwiseProduct(qdot) - push_rate;
  at.rate_size = resistance_size(at.acceleration) + stiffness.cwiseProduct(qdot.cwiseAbs()) +
                 push_rate.cwiseAbs();
  if (free.forced) {
    at.force_rate += free.frequency * free.force_rates(theta);
    at.rate_size += free.highest_frequency() * free.force_sizes();
  }
  at.jerk = held_back(at.force_rate);
  return at;
}

CurvePoint<double> ForcesAtStart::gap_rate(const Vector& row, const Vector& qdot, int order) const {
  const double rates[] = {-row.dot(qdot), -row.dot(acceleration), -row.dot(jerk)};
  const Vector sizes[] = {qdot.cwiseAbs(), size, rate_size};
  CurvePoint<double> point;
  point.value = rates[order - 1];
  if (order < 3) point.slope = rates[order];
  point.noise = kForceRoundings * row.cwiseAbs().dot(sizes[order - 1]);
  return point;
}

int depth_multiplicity(const ContactPhase<double>& phase, int stop, int known, const Vector& row,
                       const Vector& qdot) {
  if (known > 0) return known;
  if (row.dot(qdot) > speed_rounding<double>(row, qdot)) return 1;
  const CurvePoint<double> fall = phase.gap_rate(stop, 2);
  return std::abs(fall.value) > fall.noise ? 2 : 3;
}

int left_at_once(const std::vector<Vector>& rows, const std::vector<double>& depths,
                 const Vector& qdot) {
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (!(depths[k] > 0.0) && rows[k].dot(qdot) < -speed_rounding<double>(rows[k], qdot))
      return static_cast<int>(k);
  return -1;
}

}  // namespace graze
