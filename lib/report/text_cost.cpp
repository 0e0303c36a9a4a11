#include <fmt/format.h>

#include "graze/report/table.hpp"
#include "graze/report/text.hpp"

namespace graze {
namespace {

std::string error_text(const std::optional<double>& error) {
  return error ? fmt::format("{:.2g}", *error) : "-";
}

// "740 us"
std::string time_text(double seconds) {
  if (seconds >= 1.0) return fmt::format("{:.3g} s", seconds);
  if (seconds >= 1e-3) return fmt::format("{:.3g} ms", 1e3 * seconds);
  return fmt::format("{:.3g} us", 1e6 * seconds);
}

}  // namespace

std::string to_text(const CostRecord& record) {
  const FlowCosts& costs = record.costs;
  const bool timed = costs.impacts > 0;
  Table table({"flow", "setting", timed ? "error of impacts (s)" : "error / amplitude",
               "error of state", "time / period", "evaluations / period", "same impacts"});
  for (const FlowCost& row : costs.rows)
    table.add({row.flow, row.setting, error_text(row.error), error_text(row.state_error),
               time_text(row.seconds_per_period), fmt::format("{:.4g}", row.evaluations_per_period),
               !row.message.empty() ? "failed"
               : row.impacts_agree  ? "yes"
                                    : "no"});
  std::string text = table.empty() ? "" : table.text() + "\n";
  text +=
      fmt::format("compared over: {}; reference: exact flow, 50 digits\n", compared_span(costs));
  if (!costs.reference_message.empty())
    text += fmt::format("the reference ended there: {}\n", costs.reference_message);
  if (const FlowCost* best = cheapest(costs, costs.allowed))
    text += fmt::format("for tolerance {:g} (an error of {:.2g}{}): {}{}, {} a period\n",
                        costs.tolerance, costs.allowed, timed ? " s" : "", best->flow,
                        best->setting.empty() ? "" : " with " + best->setting,
                        time_text(best->seconds_per_period));
  else if (!costs.rows.empty())
    text += fmt::format("no setting meets tolerance {:g} (an error of {:.2g}{})\n", costs.tolerance,
                        costs.allowed, timed ? " s" : "");
  if (!record.outcome.message.empty())
    text += fmt::format("{}: {}\n", record.outcome.name, record.outcome.message);
  return text;
}

}  // namespace graze
