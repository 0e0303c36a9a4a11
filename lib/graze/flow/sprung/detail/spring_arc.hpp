// What a phase on compressed springs tells of them, whether it is integrated or has a closed form.
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

// The coefficient of its dashpot, N s/m; 0 without one.
inline double dashpot_of(const ContactForce& law) {
  return law.damping == ContactDamping::kNone ? 0.0 : law.coefficient;
}

// The force of a linear spring with or without a dashpot, N, from its depth.
Observable<double> linear_force(const ContactForce& law, const Observable<double>& depth);

// What a structure on compressed springs is made of.
struct SprungEquations {
  ConstrainedStructure<double> structure;
  SprungSystem system;
  std::string refusal{};
};

// Of a structure that does not turn.
SprungEquations sprung_equations(const System& system, const PhaseKey& key);

// The springs of a phase for what it integrates.
void add_springs(const System& system, const PhaseKey& key,
                 const ConstrainedStructure<double>& structure, SprungSystem& equations);

// Of a sum of forces, each of its size.
inline constexpr double kForceRoundings = 16.0 * std::numeric_limits<double>::epsilon();

// By loaded springs at these depths, m, on all coordinates, N; and its rate, N/s.
Vector spring_push(const SprungSystem& equations, const std::vector<double>& depths,
                   const Vector& qdot);
Vector spring_push_rate(const SprungSystem& equations, const std::vector<double>& depths,
                        const Vector& qdot, const Vector& acceleration);

// What acts on the structure at the start of an arc, on all coordinates: the forces but for those
// of what holds, N, what these leave of them, and the rates of both; the sizes of the terms of
// force and rate, for their rounding. What moves nothing is zero here without rounding.
struct ForcesAtStart {
  Vector force, acceleration, force_rate, jerk, size, rate_size;
  // A derivative of the gap with this row (ContactPhase::gap_rate).
  CurvePoint<double> gap_rate(const Vector& row, const Vector& qdot, int order) const;
};
ForcesAtStart forces_at_start(const ConstrainedStructure<double>& structure,
                              const SprungSystem& equations, const std::vector<double>& depths,
                              double theta, const Vector& q, const Vector& qdot);

// How the depth of a spring leaves zero at the start of an arc, as a power of time: as it is known,
// or 0; else at a speed, pushed, or by the rate of the push.
int depth_multiplicity(const ContactPhase<double>& phase, int stop, int known, const Vector& row,
                       const Vector& qdot);

// Two springs at one place: what enters the one leaves the other at the same instant. Index of the
// spring that is left at the start of an arc, -1: none. `rows`: of every spring.
int left_at_once(const std::vector<Vector>& rows, const std::vector<double>& depths,
                 const Vector& qdot);

}  // namespace graze
