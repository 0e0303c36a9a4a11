#include "graze/hybrid/smallest_gap.hpp"

#include <algorithm>
#include <cmath>

#include "graze/hybrid/clearance.hpp"
#include "graze/system/gap_value.hpp"

namespace graze {

void note_gap(double gap, std::optional<double>& smallest) {
  smallest = std::min(gap, smallest.value_or(gap));
}

void note_gap_at(const RigidStop& stop, const Vector& q, std::optional<double>& smallest) {
  const GapValue<double> gap = gap_value<double>(stop.row, q, stop.gap);
  const bool gives_way = stop.spring && gap.value < 0.0;
  note_gap(gives_way || std::abs(gap.value) <= gap.rounding ? 0.0 : gap.value, smallest);
}

void note_minimum(const ArcCurve<double>& gap, std::optional<double>& smallest) {
  const std::optional<double> least = smallest_minimum(gap);
  if (least && std::isfinite(*least)) note_gap(std::max(*least, 0.0), smallest);
}

}  // namespace graze
