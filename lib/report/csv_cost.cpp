#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "graze/report/csv.hpp"
#include "graze/report/csv_cell.hpp"

namespace graze {

std::string costs_csv(const CostRecord& record) {
  std::string text =
      "flow,setting,error,state_error,seconds_per_period,evaluations_per_period,impacts_agree\n";
  for (const FlowCost& row : record.costs.rows)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{}\n", row.flow, row.setting,
                   csv_cell(row.error.value_or(std::nan(""))),
                   csv_cell(row.state_error.value_or(std::nan(""))),
                   csv_cell(row.seconds_per_period), csv_cell(row.evaluations_per_period),
                   row.impacts_agree ? 1 : 0);
  return text;
}

}  // namespace graze
