#include "graze/record/detail/cost_record.hpp"

#include <fmt/format.h>

#include "graze/study/cost/detail/extended_contact.hpp"

namespace graze {

Outcome cost_outcome(const FlowCosts& costs, StopReason stopped) {
  if (stopped == StopReason::kInterrupted)
    return {"interrupted", fmt::format("stopped after {} settings", costs.rows.size())};
  if (stopped == StopReason::kOutOfTime)
    return {"budget", fmt::format("the budget of computing time was spent after {} settings",
                                  costs.rows.size())};
  if (costs.rows.empty())
    return {"none", "there is no motion to compare: " + costs.reference_message};
  // The exact flow stands first; without its motion there is nothing to choose.
  const std::string& failure = costs.rows.front().compared.message;
  if (!failure.empty()) return {"budget", "the exact flow did not get to the end: " + failure};
  return {"measured", ""};
}

std::string reference_name(const FlowCosts& costs) {
  if (costs.turns) return "fehlberg78, as far as bulirsch-stoer agrees with it";
  if (!costs.compliant) return "exact, 50 digits";
  return fmt::format("exact, 50 digits; contacts with compliant stops integrated to {:g} a step",
                     kReferenceTolerance);
}

std::string compared_span(const FlowCosts& costs, Units units) {
  const std::string second = unit_behind(units, "s");
  if (costs.impacts == 0) return fmt::format("no impacts, {:.6g}{}", costs.end_time, second);
  return fmt::format("first {} {}{}, {:.6g}{}", costs.impacts,
                     costs.compliant ? "contact" : "impact", costs.impacts == 1 ? "" : "s",
                     costs.end_time, second);
}

}  // namespace graze
