// How small deviations of a motion grow along an arc on compressed springs, and how they pass the
// ends of a contact.
//
// The variational equations are integrated with the motion, by the same method and in the same
// units (sprung_rates.hpp); each deviation is counted by its own size. An instant at which a spring
// begins or ceases to act passes them unchanged where its force is continuous there. Where it sets
// in or ends with C T x' at depth zero, a deviation that reaches the surface earlier by b.dq feels
// that much longer: dq' changes by C T b.dq along the stop's row, down at the entry and up at the
// end (the saltation matrix, with the speed divided out; so it holds at any speed).
#pragma once

#include <optional>

#include "graze/flow/sprung/detail/spring_arc.hpp"
#include "graze/flow/variation/detail/deviation.hpp"

namespace graze {

// Of a step, against their own sizes: derivatives are needed no finer.
inline constexpr double kDeviationTolerance = 1e-13;

// Deviations at the end of the arc of s seconds that `phase` was started on, from `start` at
// forcing phase theta. Requires modes that do not turn, zero delays, and deviations that fit its
// closed stops (see `hold`): what holds the structure projects all that acts, in all coordinates.
Deviations sprung_deviations(const System& system, const SpringArc& phase, const State& start,
                             double theta, double s, const Deviations& deviations);

// The same for the one deviation by a parameter that moves the system along `tangent`, with the
// forcing phase as the clock (parameter_growth.hpp).
Deviations sprung_parameter_deviation(const System& system, const System& tangent,
                                      const SpringArc& phase, const State& start, double theta,
                                      double s, const Deviations& column);

// The same in closed form: nothing where the arc has none, where stops are closed, or where the
// parameter is the exponent of a spring.
std::optional<Deviations> linear_spring_parameter_deviation(const System& system,
                                                            const System& tangent,
                                                            const SpringArc& phase,
                                                            const State& start, double theta,
                                                            double s, const Deviations& column);

// N s/m: by what times b.dq the velocities deviate less along the row of a stop once its contact
// has begun at the surface, and more once it has ended there.
double surface_resistance(const ContactForce& law);

}  // namespace graze
