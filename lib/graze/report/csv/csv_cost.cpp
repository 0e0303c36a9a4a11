#include <fmt/format.h>

#include <iterator>

#include "graze/record/detail/cost_record.hpp"
#include "graze/report/csv/csv.hpp"
#include "graze/report/csv/detail/csv_cell.hpp"

namespace graze {

std::string costs_csv(const CostRecord& record) {
  std::string text =
      "flow,setting,error,state_error,seconds_per_period,evaluations_per_period,impacts_agree\n";
  for (const FlowCost& row : record.costs.rows)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{}\n", row.flow, row.setting,
                   csv_cell(row.compared.error), csv_cell(row.compared.state_error),
                   csv_cell(row.seconds_per_period), csv_cell(row.evaluations_per_period),
                   row.compared.impacts_agree ? 1 : 0);
  return text;
}

std::string mode_costs_csv(const CostRecord& record) {
  std::string text = "modes,error,seconds_per_period,evaluations_per_period\n";
  for (const ModeCost& row : record.modes)
    fmt::format_to(std::back_inserter(text), "{},{},{},{}\n", row.modes, csv_cell(row.error),
                   csv_cell(row.seconds_per_period), csv_cell(row.evaluations_per_period));
  return text;
}

std::string closure_costs_csv(const CostRecord& record) {
  std::string text =
      "closure_speed,error,state_error,seconds_per_period,impacts_per_period,impacts_agree\n";
  for (const ClosureCost& row : record.closure.rows)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}\n", csv_cell(row.speed),
                   csv_cell(row.compared.error), csv_cell(row.compared.state_error),
                   csv_cell(row.seconds_per_period), csv_cell(row.impacts_per_period),
                   row.compared.impacts_agree ? 1 : 0);
  return text;
}

std::string corrector_costs_csv(const CostRecord& record) {
  std::string text = "predicted,steps,residual,error,seconds\n";
  for (const CorrectorCost& row : record.corrector.rows)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", row.predicted ? 1 : 0, row.steps,
                   csv_cell(row.residual), csv_cell(row.error), csv_cell(row.seconds));
  return text;
}

std::string contact_orders_csv(const CostRecord& record) {
  std::string text = "spring,method,order,steps,step,error,seconds,evaluations\n";
  if (!record.contact) return text;
  for (const ContactOrder& line : record.contact->lines)
    for (const ContactOrderRow& row : line.rows)
      fmt::format_to(std::back_inserter(text), "{},\"{}\",{},{},{},{},{},{}\n", line.spring,
                     line.method, row.steps > 0 ? csv_cell(line.order) : "", row.steps,
                     csv_cell(row.step), csv_cell(row.error), csv_cell(row.seconds),
                     csv_cell(row.evaluations));
  return text;
}

}  // namespace graze
