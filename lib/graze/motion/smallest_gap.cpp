#include "graze/motion/detail/smallest_gap.hpp"

#include <algorithm>
#include <cmath>

#include "graze/motion/detail/clearance.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {

void note_gap(double gap, RunTotals& totals) {
  totals.smallest_gap = std::min(gap, totals.smallest_gap.value_or(gap));
}

void note_gap_at(const Stop& stop, const Vector& q, RunTotals& totals) {
  const GapValue<double> gap = gap_value<double>(stop.row, q, stop.gap);
  const double value = std::abs(gap.value) <= gap.rounding ? 0.0 : gap.value;
  if (!stop.is_compliant()) totals.penetration = std::max(totals.penetration, -value);
  note_gap(value, totals);
}

void note_minimum(const ArcCurve<double>& gap, RunTotals& totals) {
  const std::optional<double> least = smallest_minimum(gap);
  if (least && std::isfinite(*least)) note_gap(std::max(*least, 0.0), totals);
}

}  // namespace graze
