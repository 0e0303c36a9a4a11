#include <fmt/format.h>

#include "graze/flow/detail/phase_choice.hpp"
#include "graze/motion/simulation.hpp"

namespace graze {

std::vector<std::string> unstable_stops(const System& system) {
  std::vector<std::string> warnings;
  // The other stops do not take part, and there may be many.
  System alone = system;
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    if (system.stops[i].is_compliant()) continue;  // it gives way, and holds nothing
    alone.stops.assign(1, system.stops[i]);
    const std::string refusal = make_contact_phase<double>(alone, {{0}})->refusal();
    if (!refusal.empty())
      warnings.push_back(
          fmt::format("motion held by stop {} cannot be followed: {}", i + 1, refusal));
  }
  return warnings;
}

}  // namespace graze
