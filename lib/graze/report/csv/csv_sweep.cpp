#include <fmt/format.h>

#include <iterator>

#include "graze/report/csv/csv.hpp"
#include "graze/report/csv/detail/csv_amplitudes.hpp"
#include "graze/report/csv/detail/csv_cell.hpp"
#include "graze/report/names/detail/sweep_names.hpp"

namespace graze {
std::string sweep_csv(const DiagramRecord& record) {
  std::string text =
      "value,start,status,attractor,period,impacts,periods,remaining,sample,stop,period_index,"
      "phase,speed,displacement,velocity";
  const std::vector<MeasuredPlace>& places = record.branches.amplitudes.places;
  text += amplitude_columns(places) + "\n";
  for (const SweepRow& row : record.swept.rows) {
    const AttractorClass attractor = attractor_class(row);
    const bool repeats = attractor.period > 0;
    const std::string start = fmt::format(
        "{},{},{},{},{},{},{},{}", csv_cell(row.value), name_of(row.start), name_of(row.status),
        attractor_kind(attractor), repeats ? fmt::format("{}", attractor.period) : "",
        repeats && attractor.kind != SettledKind::kSticks ? fmt::format("{}", attractor.impacts)
                                                          : "",
        row.motion.periods, repeats ? csv_cell(row.motion.remaining) : "");
    const std::string end =
        amplitude_cells(places, row.amplitudes ? &*row.amplitudes : nullptr) + "\n";
    int sample = 0;
    if (record.section == DiagramSection::kImpact)
      for (const MetImpact& impact : row.motion.impacts)
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},,{}", start, ++sample,
                       impact.stop + 1, period_index(row, impact), csv_cell(impact_phase(impact)),
                       csv_cell(impact.speed), end);
    else
      for (const SweepRow::StopState& state : row.stop_states) {
        fmt::format_to(std::back_inserter(text), "{},{},{},{},,,{},{}{}", start, sample + 1,
                       state.stop + 1, static_cast<std::size_t>(sample) / stops_seen(row),
                       csv_cell(state.displacement), csv_cell(state.velocity), end);
        ++sample;
      }
    // A value without samples has its line all the same.
    if (sample == 0) fmt::format_to(std::back_inserter(text), "{},,,,,,,{}", start, end);
  }
  return text;
}

std::string exponents_csv(const DiagramRecord& record) {
  std::string text = "value,period,periods,impacts,lost";
  const Eigen::Index count = 2 * record.branches.system.modes();
  for (Eigen::Index j = 1; j <= count; ++j) text += fmt::format(",exponent_{}", j);
  for (Eigen::Index j = 1; j <= count; ++j) text += fmt::format(",error_{}", j);
  text += "\n";
  for (const SweepRow& row : record.swept.rows) {
    text += csv_cell(row.value);
    if (!row.exponents) {
      text += std::string(static_cast<std::size_t>(4 + 2 * count), ',') + "\n";
      continue;
    }
    const Exponents& exponents = *row.exponents;
    text += fmt::format(",{},{},{},{}", row.motion.period, exponents.periods, exponents.impacts,
                        exponents.lost);
    for (const Vector& list : {exponents.values, exponents.errors})
      for (const double value : list) text += "," + csv_cell(value);
    text += "\n";
  }
  return text;
}

}  // namespace graze
