#include <fmt/format.h>

#include "graze/record/detail/sensitivity_record.hpp"
#include "graze/report/csv/csv.hpp"

namespace graze {

ResultTable sensitivity_table(const SensitivityRecord& record) {
  std::string names = "second,value,impacts";
  for (std::size_t i = 1; i <= record.probes.size(); ++i)
    names += fmt::format(",peak_{0},s1_{0},end_{0},s2_{0}", i);
  ResultTable table(names);
  for (const SensitivityCurve& curve : record.curves)
    for (std::size_t k = 0; k < curve.runs.size(); ++k) {
      const ValueRun& run = curve.runs[k];
      table.add(record.second.empty() ? NAN : curve.second, run.value, run.impacts.size());
      for (std::size_t i = 0; i < record.probes.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(k), probe = static_cast<Eigen::Index>(i);
        table.add(run.peaks[i], curve.s1(at, probe), run.ends[i], curve.s2(at, probe));
      }
    }
  return table;
}

}  // namespace graze
