#include "graze/report/csv/csv.hpp"
#include "graze/report/csv/detail/csv_amplitudes.hpp"
#include "graze/report/names/detail/map_names.hpp"
#include "graze/report/names/detail/sweep_names.hpp"

namespace graze {

ResultTable map_table(const MapRecord& record) {
  const AttractorMap& map = record.map;
  std::string names =
      "x,y,status,attractor,period,impacts,impacts_per_period,peak_speed,stuck_part,"
      "exponent";
  names += amplitude_columns(record.places);
  ResultTable table(names);
  const auto only = [](bool exists, int value) {
    return exists ? std::optional(value) : std::nullopt;
  };
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const MapCell& cell = map.cells[i];
    if (!cell.is_known) continue;
    const AttractorClass& attractor = cell.attractor;
    const bool repeats = attractor.period > 0;
    table.add(map.options.x_at(i), map.options.y_at(i), name_of(attractor.status),
              only(cell.place >= 0, cell.place + 1), only(repeats, attractor.period),
              only(repeats && attractor.kind != SettledKind::kSticks, attractor.impacts),
              cell_value(cell, MapQuantity::kImpacts), cell_value(cell, MapQuantity::kSpeed),
              cell_value(cell, MapQuantity::kStuck), cell.exponent);
    add_amplitudes(record.places, cell.amplitudes ? &*cell.amplitudes : nullptr, table);
  }
  return table;
}

}  // namespace graze
