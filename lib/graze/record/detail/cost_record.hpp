// The result of comparing flows: what accuracy costs in time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/record/records.hpp"
#include "graze/study/compare/detail/contact_order.hpp"
#include "graze/study/cost/detail/accuracy_costs.hpp"
#include "graze/study/cost/detail/flow_cost.hpp"

namespace graze {

// The order of Runge-Kutta steps across the first contact with a compliant stop.
struct ContactOrders {
  FirstContact first;
  std::vector<ContactOrder> lines;  // none where no such contact begins
};

struct CostRecord {
  RunInfo info;
  FlowCosts costs;
  std::vector<ModeCost> modes;  // empty where their number is not free
  ClosureCosts closure;
  CorrectorCosts corrector;
  std::optional<ContactOrders> contact;  // where a stop is compliant
  std::vector<std::string> warnings;
  Outcome outcome;
};

// "measured"; "budget" where the time or the impacts were spent before, "none" where there is
// nothing to compare.
Outcome cost_outcome(const FlowCosts& costs, StopReason stopped);

// What flows are compared with.
std::string reference_name(const FlowCosts& costs);

// "first 20 impacts, 2.5 s", "first 20 contacts, 2.5 s" or "no impacts, 2.5 s"
std::string compared_span(const FlowCosts& costs, Units units);

}  // namespace graze
