#include <fmt/format.h>

#include "graze/report/csv/csv.hpp"
#include "graze/report/csv/detail/csv_amplitudes.hpp"
#include "graze/report/names/detail/sweep_names.hpp"

namespace graze {

ResultTable sweep_table(const DiagramRecord& record) {
  std::string names =
      "value,start,status,attractor,period,impacts,periods,remaining,sample,stop,"
      "period_index,phase,speed,displacement,velocity";
  const std::vector<MeasuredPlace>& places = record.branches.amplitudes.places;
  names += amplitude_columns(places);
  ResultTable table(names);
  const auto only = [](bool exists, auto value) {
    return exists ? std::optional(value) : std::nullopt;
  };
  for (const SweepRow& row : record.swept.rows) {
    const AttractorClass attractor = attractor_class(row);
    const bool repeats = attractor.period > 0;
    const auto begin = [&] {
      table.add(row.value, name_of(row.start), name_of(row.status), attractor_kind(attractor),
                only(repeats, attractor.period),
                only(repeats && attractor.kind != SettledKind::kSticks, attractor.impacts),
                row.motion.periods, only(repeats, row.motion.remaining));
    };
    const auto end = [&] {
      add_amplitudes(places, row.amplitudes ? &*row.amplitudes : nullptr, table);
    };
    int sample = 0;
    if (record.section == DiagramSection::kImpact)
      for (const MetImpact& impact : row.motion.impacts) {
        begin();
        table.add(++sample, impact.stop + 1, period_index(row, impact), impact_phase(impact),
                  impact.speed);
        table.skip(2);
        end();
      }
    else
      for (const SweepRow::StopState& state : row.stop_states) {
        begin();
        table.add(sample + 1, state.stop + 1, static_cast<std::size_t>(sample) / stops_seen(row));
        table.skip(2).add(state.displacement, state.velocity);
        end();
        ++sample;
      }
    if (sample > 0) continue;
    // A value without samples has its line all the same.
    begin();
    table.skip(7);
    end();
  }
  return table;
}

ResultTable exponents_table(const DiagramRecord& record) {
  std::string names = "value,period,periods,impacts,lost";
  const Eigen::Index count = 2 * record.branches.system.modes();
  for (const char* what : {"exponent", "error"})
    for (Eigen::Index j = 1; j <= count; ++j) names += fmt::format(",{}_{}", what, j);
  ResultTable table(names);
  for (const SweepRow& row : record.swept.rows) {
    table.add(row.value);
    if (!row.exponents) {
      table.skip(static_cast<std::size_t>(4 + 2 * count));
      continue;
    }
    const Exponents& exponents = *row.exponents;
    table.add(row.motion.period, exponents.periods, exponents.impacts, exponents.lost);
    for (const Vector& list : {exponents.values, exponents.errors})
      for (const double value : list) table.add(value);
  }
  return table;
}

}  // namespace graze
