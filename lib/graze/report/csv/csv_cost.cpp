#include "graze/record/detail/cost_record.hpp"
#include "graze/report/csv/csv.hpp"

namespace graze {

ResultTable costs_table(const CostRecord& record) {
  ResultTable table(
      "flow,setting,error,state_error,seconds_per_period,evaluations_per_period,"
      "impacts_agree");
  for (const FlowCost& row : record.costs.rows)
    table.add(row.flow, row.setting, row.compared.error, row.compared.state_error,
              row.seconds_per_period, row.evaluations_per_period, row.compared.impacts_agree);
  return table;
}

ResultTable mode_costs_table(const CostRecord& record) {
  ResultTable table("modes,error,seconds_per_period,evaluations_per_period");
  for (const ModeCost& row : record.modes)
    table.add(row.modes, row.error, row.seconds_per_period, row.evaluations_per_period);
  return table;
}

ResultTable closure_costs_table(const CostRecord& record) {
  ResultTable table(
      "closure_speed,error,state_error,seconds_per_period,impacts_per_period,impacts_agree");
  for (const ClosureCost& row : record.closure.rows)
    table.add(row.speed, row.compared.error, row.compared.state_error, row.seconds_per_period,
              row.impacts_per_period, row.compared.impacts_agree);
  return table;
}

ResultTable corrector_costs_table(const CostRecord& record) {
  ResultTable table("predicted,steps,residual,error,seconds");
  for (const CorrectorCost& row : record.corrector.rows)
    table.add(row.predicted, row.steps, row.residual, row.error, row.seconds);
  return table;
}

ResultTable contact_orders_table(const CostRecord& record) {
  ResultTable table("spring,method,order,steps,step,error,seconds,evaluations");
  if (!record.contact) return table;
  for (const ContactOrder& line : record.contact->lines)
    for (const ContactOrderRow& row : line.rows) {
      table.add(line.spring, line.method);
      if (row.steps > 0)
        table.add(line.order);
      else
        table.skip(1);
      table.add(row.steps, row.step, row.error, row.seconds, row.evaluations);
    }
  return table;
}

}  // namespace graze
