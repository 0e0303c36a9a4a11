// The state of the compressed springs in a phase, whether it is integrated or has a closed form.
#pragma once

#include <limits>
#include <vector>

#include "graze/flow/exact/detail/contact_phase.hpp"
#include "graze/flow/held/detail/constrained_structure.hpp"
#include "graze/flow/stepped/detail/step_flow.hpp"

namespace graze {

// Refers to the phase. Springs are in the order of PhaseSprings::all().
struct SpringArc {
  const PhaseKey& key;
  const ConstrainedStructure<double>& structure;
  const SprungSystem& equations;      // the motion on what closed stops leave free
  const std::vector<double>& depths;  // at the start of the arc, m
  // The depth of each along the arc; empty where it is integrated.
  std::vector<Observable<double>> depth_observables{};

  const std::vector<int>& closed() const { return key.closed; }
  const PhaseSprings& springs() const { return key.springs; }
};

// The coefficient of the spring's dashpot, N s/m; 0 without one.
inline double dashpot_of(const ContactForce& law) {
  return law.damping == ContactDamping::kNone ? 0.0 : law.coefficient;
}

// The force of a linear spring with or without a dashpot, N, from its depth.
Observable<double> linear_force(const ContactForce& law, const Observable<double>& depth);

// The structure and the equations of a motion on compressed springs.
struct SprungEquations {
  ConstrainedStructure<double> structure;
  SprungSystem system;
  std::string refusal{};
};

// For a structure without a rotating hub.
SprungEquations sprung_equations(const System& system, const PhaseKey& key);

// Adds the springs of a phase to its equations.
void add_springs(const System& system, const PhaseKey& key,
                 const ConstrainedStructure<double>& structure, SprungSystem& equations);

// Rounding of a sum of forces, relative to the size of each.
inline constexpr double kForceRoundings = 16.0 * std::numeric_limits<double>::epsilon();

// The forces of loaded springs at these depths, m, on all coordinates, N; and their rate, N/s.
Vector spring_push(const SprungSystem& equations, const std::vector<double>& depths,
                   const Vector& qdot);
Vector spring_push_rate(const SprungSystem& equations, const std::vector<double>& depths,
                        const Vector& qdot, const Vector& acceleration);

// Forces at the start of an arc, on all coordinates: `force` without the contact forces of closed
// stops, N, the `acceleration` that these leave, and the rates of both; the sizes of the terms of
// force and rate, for their rounding. A force that moves nothing is exactly zero here.
struct ForcesAtStart {
  Vector force, acceleration, force_rate, jerk, size, rate_size;
  // A derivative of the gap with this row (ContactPhase::gap_rate).
  CurvePoint<double> gap_rate(const Vector& row, const Vector& qdot, int order) const;
};
ForcesAtStart forces_at_start(const ConstrainedStructure<double>& structure,
                              const SprungSystem& equations, const std::vector<double>& depths,
                              double theta, const Vector& q, const Vector& qdot);

// The power of time by which the depth of a spring leaves zero at the start of an arc: `known`
// unless it is 0; else 1 with a speed, 2 under a force, 3 with a rate of the force.
int depth_multiplicity(const ContactPhase<double>& phase, int stop, int known, const Vector& row,
                       const Vector& qdot);

// For two springs at one place: the structure leaves one when it enters the other. Returns the
// index of the spring that is left at the start of an arc, -1: none. `rows`: of every spring.
int left_at_once(const std::vector<Vector>& rows, const std::vector<double>& depths,
                 const Vector& qdot);

}  // namespace graze
