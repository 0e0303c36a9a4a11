// The result of comparing flows: what accuracy costs in time.
#pragma once

#include <string>
#include <vector>

#include "graze/record/records.hpp"
#include "graze/study/accuracy_costs.hpp"
#include "graze/study/flow_cost.hpp"

namespace graze {

struct CostRecord {
  RunInfo info;
  FlowCosts costs;
  std::vector<ModeCost> modes;  // empty where their number is not free
  ClosureCosts closure;
  CorrectorCosts corrector;
  std::vector<std::string> warnings;
  Outcome outcome;
};

// "measured"; "budget" where the time or the impacts were spent before, "none" where there is
// nothing to compare.
Outcome cost_outcome(const FlowCosts& costs, StopReason stopped);

// "first 20 impacts, 2.5 s" or "no impacts, 2.5 s"
std::string compared_span(const FlowCosts& costs);

}  // namespace graze
