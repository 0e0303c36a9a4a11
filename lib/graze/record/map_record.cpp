#include "graze/record/detail/map_record.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace graze {

Outcome map_outcome(const AttractorMap& map) {
  const std::vector<MapCell>& cells = map.cells;
  const auto known =
      std::count_if(cells.begin(), cells.end(), [](const MapCell& cell) { return cell.is_known; });
  if (const auto stopped =
          stopped_outcome(map.stopped, static_cast<std::size_t>(known), cells.size(), "cells"))
    return *stopped;
  const auto is_failed = [](const MapCell& cell) {
    return cell.attractor.status == SweepStatus::kImpactBudget ||
           cell.attractor.status == SweepStatus::kRefused;
  };
  const auto failed = std::find_if(cells.begin(), cells.end(), is_failed);
  if (failed == cells.end()) return {"complete", ""};
  return {"budget", fmt::format("{} of {} cells could not be followed to their end; the first: {}",
                                std::count_if(cells.begin(), cells.end(), is_failed), cells.size(),
                                failed->message)};
}

}  // namespace graze
