#include <fmt/format.h>

#include "graze/report/csv/csv.hpp"
#include "graze/report/csv/detail/csv_amplitudes.hpp"
#include "graze/report/csv/detail/csv_cell.hpp"
#include "graze/report/names/detail/map_names.hpp"
#include "graze/report/names/detail/sweep_names.hpp"

namespace graze {

std::string map_csv(const MapRecord& record) {
  const AttractorMap& map = record.map;
  std::string text =
      std::string(
          "x,y,status,attractor,period,impacts,impacts_per_period,peak_speed,stuck_part,exponent") +
      amplitude_columns(record.places) + "\n";
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const MapCell& cell = map.cells[i];
    if (!cell.is_known) continue;
    const AttractorClass& attractor = cell.attractor;
    const bool counted = attractor.period > 0 && attractor.kind != SettledKind::kSticks;
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{}{}\n", csv_cell(map.options.x_at(i)),
                    csv_cell(map.options.y_at(i)), name_of(attractor.status),
                    cell.place >= 0 ? std::to_string(cell.place + 1) : "",
                    attractor.period > 0 ? std::to_string(attractor.period) : "",
                    counted ? std::to_string(attractor.impacts) : "",
                    csv_cell(cell_value(cell, MapQuantity::kImpacts)),
                    csv_cell(cell_value(cell, MapQuantity::kSpeed)),
                    csv_cell(cell_value(cell, MapQuantity::kStuck)), csv_cell(cell.exponent),
                    amplitude_cells(record.places, cell.amplitudes ? &*cell.amplitudes : nullptr));
  }
  return text;
}

}  // namespace graze
