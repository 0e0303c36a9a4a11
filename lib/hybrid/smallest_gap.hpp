// The smallest gap of a run, m: of a compliant stop, which gives way, it is not below zero.
#pragma once

#include <optional>

#include "graze/flow/arc_curve.hpp"
#include "graze/system/system.hpp"

namespace graze {

void note_gap(double gap, std::optional<double>& smallest);
// That at displacements q; within its rounding of zero it is zero.
void note_gap_at(const RigidStop& stop, const Vector& q, std::optional<double>& smallest);
// The smallest minimum along a flight: beyond the first contact it is not part of the motion; the
// contact itself is zero.
void note_minimum(const ArcCurve<double>& gap, std::optional<double>& smallest);

}  // namespace graze
