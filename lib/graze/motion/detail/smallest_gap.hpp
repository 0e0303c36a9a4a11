// The smallest gap of a run, m: below zero by as much as a spring was compressed, or a rigid stop
// penetrated, which no motion does by more than rounding.
#pragma once

#include "graze/flow/exact/detail/arc_curve.hpp"
#include "graze/motion/run_events.hpp"
#include "graze/system/system.hpp"

namespace graze {

void note_gap(double gap, RunTotals& totals);
// That at displacements q; within its rounding of zero it is zero.
void note_gap_at(const Stop& stop, const Vector& q, RunTotals& totals);
// The smallest minimum along a flight: beyond the first contact it is not part of the motion; the
// contact itself is zero.
void note_minimum(const ArcCurve<double>& gap, RunTotals& totals);

}  // namespace graze
