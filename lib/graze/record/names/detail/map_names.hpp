// The words in which results speak of a map.
#pragma once

#include <functional>
#include <string>

#include "graze/record/study_records.hpp"

namespace graze {

inline constexpr MapQuantity kMapQuantities[] = {MapQuantity::kAttractor, MapQuantity::kImpacts,
                                                 MapQuantity::kExponent, MapQuantity::kSpeed,
                                                 MapQuantity::kStuck};

// "attractor", "impacts", "exponent", "speed", "stuck".
std::string name_of(MapQuantity quantity);

// "largest exponent" and its unit "1/s", ..
std::string title_of(MapQuantity quantity);
std::string unit_of(MapQuantity quantity);

// "(1,1)", or "(1,1) b" of the second of several that do the same.
std::string attractor_name(const AttractorMap& map, std::size_t attractor);

// Of a cell, "(2,1)", "clear", "no start", ..
std::string cell_name(const AttractorMap& map, const MapCell& cell);

// Whether what the cell settles on meets no stop.
bool is_clear(const MapCell& cell);

// Of a cell as a number; not finite where it has none.
double cell_value(const MapCell& cell, MapQuantity quantity);

// What a picture shows of cells: not finite where there is nothing to show, as no speed where
// nothing is met. Refers to the record.
struct DrawnQuantity {
  std::string title, unit;  // SI
  std::function<double(const MapCell&)> of;
};
DrawnQuantity drawn_quantity(const MapRecord& record, MapQuantity quantity);

}  // namespace graze
