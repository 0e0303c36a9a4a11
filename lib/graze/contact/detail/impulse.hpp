// The impulse laws of a rigid stop: one rank-one jump of the modal velocities,
//
//   q'+ = q'- - (1 + r) d (b.q'-),   b.d = 1   =>   v+ = -r v-,
//
// with b the contact row (v = b.q' is the approach speed) and d the direction of the law.
#pragma once

#include "graze/base/vector.hpp"

namespace graze {

// Generalised impulse with momentum balance: d = b/(b.b).
Vector momentum_direction(const Vector& row);
Vector momentum_direction_rate(const Vector& row, const Vector& row_rate);

// Phi^-1 R Phi of Wagg (2004), eq. 13: d = Phi^-1 e_i, with `sign` the sign of the row against
// phi(x_i) (-1 for a stop below). Every other collocation point keeps its velocity.
Vector collocation_direction(const Matrix& phi, int point, double sign);
Vector collocation_direction_rate(const Matrix& phi, const Matrix& phi_rate,
                                  const Vector& direction);

// Change of kinetic energy (J) by the impact of velocities `before`, v = row.before: the loss (1 -
// r^2) v^2 m_eff/2 of the momentum law, and the gain or loss by the part of the direction that is
// oblique to the row.
double impact_energy_change(const Vector& row, const Vector& direction, const Vector& before,
                            double restitution);

// One stop's part in that change when several are hit at once: it undid `impulse` (m/s along its
// direction) while its approach speed went from v to v_after; `mean` is the mean of the velocities
// before and after.
double shared_energy_change(const Vector& row, const Vector& direction, double impulse, double v,
                            double v_after, const Vector& mean);

// The largest factor by which the jump can multiply kinetic energy: 1 for the momentum law, more
// for an oblique direction (the square of the largest singular value of I - (1 + r) d b^T).
double worst_energy_gain(const Vector& row, const Vector& direction, double restitution);

}  // namespace graze
