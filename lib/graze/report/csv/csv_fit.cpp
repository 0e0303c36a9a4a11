#include "graze/record/detail/fit_record.hpp"
#include "graze/report/csv/csv.hpp"

namespace graze {

ResultTable fit_table(const FitRecord& record) {
  const FitResult& result = record.result;
  ResultTable table("series," + abscissa_of(result.kind).name +
                    ",measured,predicted,residual,uncertainty");
  for (const FittedSeries& series : result.series)
    for (Eigen::Index i = 0; i < result.at.size(); ++i) {
      table.add(series.name, result.at[i], series.measured[i], series.predicted[i],
                series.measured[i] - series.predicted[i]);
      table.add(series.uncertainty.size() > 0 ? series.uncertainty[i] : NAN);
    }
  return table;
}

ResultTable parameters_table(const FitRecord& record) {
  ResultTable table("parameter,value,uncertainty,interval_low,interval_high,at_limit");
  for (const FittedParameter& p : record.result.parameters)
    table.add(p.name, p.value, p.uncertainty, p.uncertainty ? p.interval_low : NAN,
              p.uncertainty ? p.interval_high : NAN, p.at_limit);
  return table;
}

}  // namespace graze
