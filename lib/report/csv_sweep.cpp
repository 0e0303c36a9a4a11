#include <fmt/format.h>

#include <iterator>

#include "graze/report/csv.hpp"
#include "graze/report/csv_cell.hpp"
#include "graze/report/sweep_names.hpp"

namespace graze {
namespace {}  // namespace

std::string sweep_csv(const DiagramRecord& record) {
  std::string text =
      "value,start,status,attractor,period,impacts,periods,remaining,sample,stop,period_index,"
      "phase,speed,displacement,velocity\n";
  for (const SweepRow& row : record.swept.rows) {
    const AttractorClass attractor = attractor_class(row);
    const bool repeats = attractor.period > 0;
    const std::string start = fmt::format(
        "{},{},{},{},{},{},{},{}", csv_cell(row.value), name_of(row.start), name_of(row.status),
        attractor_kind(attractor), repeats ? fmt::format("{}", attractor.period) : "",
        repeats && attractor.kind != SettledKind::kSticks ? fmt::format("{}", attractor.impacts)
                                                          : "",
        row.motion.periods, repeats ? csv_cell(row.motion.remaining) : "");
    int sample = 0;
    if (record.section == DiagramSection::kImpact)
      for (const MetImpact& impact : row.motion.impacts)
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},,\n", start, ++sample,
                       impact.stop + 1, period_index(row, impact), csv_cell(impact_phase(impact)),
                       csv_cell(impact.speed));
    else
      for (const SweepRow::Strobe& strobe : row.strobes) {
        const std::size_t stops = row.strobes.size() / row.motion.strobes.size();
        fmt::format_to(std::back_inserter(text), "{},{},{},{},,,{},{}\n", start, sample + 1,
                       strobe.stop + 1, static_cast<std::size_t>(sample) / stops,
                       csv_cell(strobe.displacement), csv_cell(strobe.velocity));
        ++sample;
      }
    // A value without samples has its line all the same.
    if (sample == 0) fmt::format_to(std::back_inserter(text), "{},,,,,,,\n", start);
  }
  return text;
}

}  // namespace graze
