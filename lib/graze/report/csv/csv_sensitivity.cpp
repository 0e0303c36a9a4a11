#include <fmt/format.h>

#include "graze/record/detail/sensitivity_record.hpp"
#include "graze/report/csv/csv.hpp"
#include "graze/report/csv/detail/csv_cell.hpp"

namespace graze {

std::string sensitivity_csv(const SensitivityRecord& record) {
  std::string text = "second,value,impacts";
  for (std::size_t i = 1; i <= record.probes.size(); ++i)
    text += fmt::format(",peak_{0},s1_{0},end_{0},s2_{0}", i);
  text += "\n";
  for (const SensitivityCurve& curve : record.curves)
    for (std::size_t k = 0; k < curve.runs.size(); ++k) {
      const ValueRun& run = curve.runs[k];
      text += (record.second.empty() ? std::string() : csv_cell(curve.second)) + "," +
              csv_cell(run.value) + "," + std::to_string(run.impacts.size());
      for (std::size_t i = 0; i < record.probes.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(k), probe = static_cast<Eigen::Index>(i);
        for (const double value :
             {run.peaks[i], curve.s1(at, probe), run.ends[i], curve.s2(at, probe)})
          text += "," + csv_cell(value);
      }
      text += "\n";
    }
  return text;
}

}  // namespace graze
