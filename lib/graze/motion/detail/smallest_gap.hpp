// The smallest gap of a run, m: negative by the depth at a spring, or by the penetration of a rigid
// stop, which is never more than rounding.
#pragma once

#include "graze/flow/exact/detail/arc_curve.hpp"
#include "graze/motion/run_events.hpp"
#include "graze/system/system.hpp"

namespace graze {

void note_gap(double gap, RunTotals& totals);
// Notes the gap at displacements q; within its rounding of zero it is zero.
void note_gap_at(const Stop& stop, const Vector& q, RunTotals& totals);
// Notes the smallest minimum along a flight. Minima beyond the first contact are no part of the
// motion; the contact itself is zero.
void note_minimum(const ArcCurve<double>& gap, RunTotals& totals);

}  // namespace graze
