// How small deviations of a motion grow along an arc on compressed springs, and how they pass the
// ends of a contact.
//
// The variational equations are integrated with the motion, by the same method and in the same
// units (sprung_rates.hpp); each deviation is measured by its own size. Deviations do not change
// when a spring begins or ceases to act with a continuous force. Where the force sets in or ends
// with C T x' at depth zero, a deviation that reaches the surface earlier by b.dq feels it that
// much longer: dq' changes by C T b.dq along the stop's row, down at the entry and up at the end
// (the saltation matrix with the speed divided out, so that it holds at any speed).
#pragma once

#include <optional>

#include "graze/flow/sprung/detail/spring_arc.hpp"
#include "graze/flow/variation/detail/deviation.hpp"

namespace graze {

// Tolerance of a step, against the size of each deviation; derivatives need no more.
inline constexpr double kDeviationTolerance = 1e-13;

// Deviations at the end of the arc of s seconds that `phase` was started on, from `start` at
// forcing phase theta. Requires a structure without a rotating hub, zero delays, and deviations
// that satisfy the constraints of closed stops (see `hold`), which project all forces in all
// coordinates.
Deviations sprung_deviations(const System& system, const SpringArc& phase, const State& start,
                             double theta, double s, const Deviations& deviations);

// The same for the derivative by the parameter of `tangent`, with the forcing phase as the clock
// (parameter_growth.hpp).
Deviations sprung_parameter_deviation(const System& system, const System& tangent,
                                      const SpringArc& phase, const State& start, double theta,
                                      double s, const Deviations& column);

// The same in closed form; returns nullopt when the arc has none, when stops are closed, or when
// the parameter is the exponent of a spring.
std::optional<Deviations> linear_spring_parameter_deviation(const System& system,
                                                            const System& tangent,
                                                            const SpringArc& phase,
                                                            const State& start, double theta,
                                                            double s, const Deviations& column);

}  // namespace graze
