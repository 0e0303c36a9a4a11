#include <fmt/format.h>

#include "graze/record/detail/run_diagram_record.hpp"
#include "graze/report/csv/csv.hpp"

namespace graze {

ResultTable run_impacts_table(const RunDiagramRecord& record) {
  ResultTable table("value,impact,time,stop,speed");
  for (const ValueRun& run : record.runs) {
    if (run.impacts.empty()) table.add(run.value).skip(4);
    for (std::size_t k = 0; k < run.impacts.size(); ++k) {
      const RunImpact& impact = run.impacts[k];
      table.add(run.value, k + 1, impact.time, impact.stop + 1, impact.speed);
    }
  }
  return table;
}

ResultTable runs_table(const RunDiagramRecord& record) {
  std::string names = "value,reached_end,impacts";
  for (std::size_t i = 1; i <= record.probes.size(); ++i)
    names += fmt::format(",peak_{0},end_{0}", i);
  ResultTable table(names);
  for (const ValueRun& run : record.runs) {
    table.add(run.value, run.outcome == RunOutcome::kReachedEnd, run.impacts.size());
    for (std::size_t i = 0; i < record.probes.size(); ++i) table.add(run.peaks[i], run.ends[i]);
  }
  return table;
}

}  // namespace graze
