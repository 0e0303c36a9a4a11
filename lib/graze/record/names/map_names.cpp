#include "graze/record/names/detail/map_names.hpp"

#include <limits>

#include "graze/record/names/detail/sweep_names.hpp"

namespace graze {

std::string name_of(MapQuantity quantity) {
  switch (quantity) {
    case MapQuantity::kAttractor:
      return "attractor";
    case MapQuantity::kImpacts:
      return "impacts";
    case MapQuantity::kExponent:
      return "exponent";
    case MapQuantity::kSpeed:
      return "speed";
    case MapQuantity::kMeasured:
      return "measured";
    case MapQuantity::kStuck:
      break;
  }
  return "stuck";
}

std::string title_of(MapQuantity quantity) {
  switch (quantity) {
    case MapQuantity::kAttractor:
      return "attractor";
    case MapQuantity::kImpacts:
      return "impacts a forcing period";
    case MapQuantity::kExponent:
      return "largest exponent";
    case MapQuantity::kSpeed:
      return "speed of the fastest impact";
    case MapQuantity::kMeasured:
      return "how large the motion is";
    case MapQuantity::kStuck:
      break;
  }
  return "part of the time at rest on a stop";
}

std::string unit_of(MapQuantity quantity) {
  if (quantity == MapQuantity::kExponent) return "1/s";
  return quantity == MapQuantity::kSpeed ? "m/s" : "";
}

std::string attractor_name(const AttractorMap& map, std::size_t attractor) {
  const AttractorClass& own = map.attractors[attractor].attractor;
  std::size_t before = 0, all = 0;
  for (std::size_t i = 0; i < map.attractors.size(); ++i) {
    if (map.attractors[i].attractor != own) continue;
    ++all;
    if (i < attractor) ++before;
  }
  const std::string label = attractor_label(own);
  if (all == 1) return label;
  return label + " " +
         (before < 26 ? std::string(1, static_cast<char>('a' + before))
                      : std::to_string(before + 1));
}

std::string cell_name(const AttractorMap& map, const MapCell& cell) {
  if (!cell.is_known) return "not run";
  return cell.place >= 0 ? attractor_name(map, static_cast<std::size_t>(cell.place))
                         : attractor_label(cell.attractor);
}

bool is_clear(const MapCell& cell) {
  return cell.is_known && cell.attractor.period > 0 && attractor_kind(cell.attractor) == "clear";
}

double cell_value(const MapCell& cell, MapQuantity quantity) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (!cell.is_known || cell.attractor.status == SweepStatus::kNoStart) return kNone;
  switch (quantity) {
    case MapQuantity::kAttractor:
      return cell.place;
    case MapQuantity::kImpacts:
      return cell.impacts_per_period.value_or(kNone);
    case MapQuantity::kExponent:
      return cell.exponent.value_or(kNone);
    case MapQuantity::kSpeed:
      return cell.peak_speed;
    case MapQuantity::kStuck:
      return cell.stuck_part;
    case MapQuantity::kMeasured:
      break;
  }
  return kNone;
}

DrawnQuantity drawn_quantity(const MapRecord& record, MapQuantity quantity) {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (quantity == MapQuantity::kMeasured)
    return {shown_title(*record.measured, record.places),
            unit_in(record.info.units, shown_unit(*record.measured, record.places)),
            [&record](const MapCell& cell) {
              if (!cell.amplitudes) return kNone;
              return shown_value(*record.measured, record.places, *cell.amplitudes).value_or(kNone);
            }};
  return {title_of(quantity), unit_in(record.info.units, unit_of(quantity)),
          [quantity](const MapCell& cell) {
            const bool blank = quantity == MapQuantity::kSpeed && is_clear(cell);
            return blank ? kNone : cell_value(cell, quantity);
          }};
}

}  // namespace graze
