#include <fmt/format.h>

#include "graze/record/detail/run_diagram_record.hpp"
#include "graze/report/csv/csv.hpp"
#include "graze/report/csv/detail/csv_cell.hpp"

namespace graze {

std::string run_impacts_csv(const RunDiagramRecord& record) {
  std::string text = "value,impact,time,stop,speed\n";
  for (const ValueRun& run : record.runs) {
    if (run.impacts.empty()) text += csv_cell(run.value) + ",,,,\n";
    for (std::size_t k = 0; k < run.impacts.size(); ++k) {
      const RunImpact& impact = run.impacts[k];
      text += fmt::format("{},{},{},{},{}\n", csv_cell(run.value), k + 1, csv_cell(impact.time),
                          impact.stop + 1, csv_cell(impact.speed));
    }
  }
  return text;
}

std::string runs_csv(const RunDiagramRecord& record) {
  std::string text = "value,reached_end,impacts";
  for (std::size_t i = 1; i <= record.probes.size(); ++i)
    text += fmt::format(",peak_{0},end_{0}", i);
  text += "\n";
  for (const ValueRun& run : record.runs) {
    text += fmt::format("{},{:d},{}", csv_cell(run.value), run.outcome == RunOutcome::kReachedEnd,
                        run.impacts.size());
    for (std::size_t i = 0; i < record.probes.size(); ++i)
      text += "," + csv_cell(run.peaks[i]) + "," + csv_cell(run.ends[i]);
    text += "\n";
  }
  return text;
}

}  // namespace graze
