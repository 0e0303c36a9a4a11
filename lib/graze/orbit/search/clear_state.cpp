#include "graze/orbit/search/detail/clear_state.hpp"

#include <algorithm>

#include "graze/system/detail/gap_value.hpp"

namespace graze {

bool is_clear(const System& system, const State& state) {
  return std::all_of(system.stops.begin(), system.stops.end(), [&](const Stop& stop) {
    const GapValue<double> gap = gap_value<double>(stop.row, state.q, stop.gap);
    return stop.is_compliant() || gap.value >= -gap.rounding;
  });
}

bool bring_clear(const System& system, State& state) {
  for (const Stop& stop : system.stops) {
    const GapValue<double> gap = gap_value<double>(stop.row, state.q, stop.gap);
    if (!stop.is_compliant() && gap.value < -gap.rounding) state.q += gap.value * stop.direction();
  }
  return is_clear(system, state);
}

}  // namespace graze
