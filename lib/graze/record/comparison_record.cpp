#include "graze/record/detail/comparison_record.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace graze {
namespace {

bool is_failed(const AttractorClass& attractor) {
  return attractor.status == SweepStatus::kImpactBudget ||
         attractor.status == SweepStatus::kRefused;
}

}  // namespace

void conclude_comparison(ComparisonRecord& record, std::size_t asked, StopReason stopped) {
  const std::vector<ComparedMotion>& motions = record.motions;
  for (std::size_t i = 1; i < motions.size(); ++i)
    record.differences.push_back(difference(motions[i - 1], motions[i], record.options));
  record.outcome = {"compared", ""};
  if (motions.size() < asked)
    if (const auto outcome = stopped_outcome(stopped, motions.size(), asked, "motions")) {
      record.outcome = *outcome;
      return;
    }
  for (std::size_t i = 0; i < motions.size(); ++i)
    if (is_failed(motions[i].attractor)) {
      record.outcome = {"budget", record.names[i] + ": " + motions[i].message};
      return;
    }
}

Outcome comparison_map_outcome(const ComparisonMap& map) {
  const std::vector<ComparedCell>& cells = map.cells;
  const auto known = std::count_if(cells.begin(), cells.end(),
                                   [](const ComparedCell& cell) { return cell.is_known; });
  if (const auto stopped =
          stopped_outcome(map.stopped, static_cast<std::size_t>(known), cells.size(), "cells"))
    return *stopped;
  const auto failed = [](const ComparedCell& cell) {
    return is_failed(cell.one) || is_failed(cell.other);
  };
  const auto first = std::find_if(cells.begin(), cells.end(), failed);
  if (first == cells.end()) return {"complete", ""};
  return {"budget", fmt::format("{} of {} cells could not be followed to their end; the first: {}",
                                std::count_if(cells.begin(), cells.end(), failed), cells.size(),
                                first->message)};
}

}  // namespace graze
