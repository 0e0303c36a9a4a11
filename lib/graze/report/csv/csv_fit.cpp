#include <fmt/format.h>

#include <iterator>

#include "graze/record/detail/fit_record.hpp"
#include "graze/report/csv/csv.hpp"
#include "graze/report/csv/detail/csv_cell.hpp"

namespace graze {

std::string fit_csv(const FitRecord& record) {
  const FitResult& result = record.result;
  std::string text =
      "series," + abscissa_of(result.kind).name + ",measured,predicted,residual,uncertainty\n";
  for (const FittedSeries& series : result.series)
    for (Eigen::Index i = 0; i < result.at.size(); ++i)
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}\n", series.name,
                     csv_cell(result.at[i]), csv_cell(series.measured[i]),
                     csv_cell(series.predicted[i]),
                     csv_cell(series.measured[i] - series.predicted[i]),
                     series.uncertainty.size() > 0 ? csv_cell(series.uncertainty[i]) : "");
  return text;
}

std::string parameters_csv(const FitRecord& record) {
  std::string text = "parameter,value,uncertainty,interval_low,interval_high,at_limit\n";
  for (const FittedParameter& p : record.result.parameters)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}\n", p.name, csv_cell(p.value),
                   csv_cell(p.uncertainty), p.uncertainty ? csv_cell(p.interval_low) : "",
                   p.uncertainty ? csv_cell(p.interval_high) : "", p.at_limit ? 1 : 0);
  return text;
}

}  // namespace graze
