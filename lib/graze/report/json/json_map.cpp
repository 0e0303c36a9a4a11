#include <algorithm>
#include <utility>
#include <vector>

#include "graze/report/json/detail/json_amplitudes.hpp"
#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_loci.hpp"
#include "graze/report/json/detail/json_plane.hpp"
#include "graze/report/json/detail/json_value.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/names/detail/map_names.hpp"
#include "graze/report/names/detail/sweep_names.hpp"

namespace graze {
namespace {

Json attractor_json(const AttractorMap& map, std::size_t i) {
  const MapAttractor& one = map.attractors[i];
  const AttractorClass& attractor = one.attractor;
  const bool repeats = attractor.period > 0, sticks = attractor.kind == SettledKind::kSticks;
  return {{"id", i + 1},
          {"attractor", attractor_name(map, i)},
          {"period", repeats ? Json(attractor.period) : Json(nullptr)},
          {"impacts", repeats && !sticks ? Json(attractor.impacts) : Json(nullptr)},
          {"sticks", sticks},
          {"cells", one.cells},
          {"first", Json::array({map.options.x_at(one.first), map.options.y_at(one.first)})}};
}

// Of every place the quantities that are shown there, a list of the cells each.
Json measured_json(const MapRecord& record, const std::vector<const MapCell*>& cells) {
  Json list = Json::array();
  for (std::size_t i = 0; i < record.places.size(); ++i) {
    Json place = {{record.places[i].stop ? "stop" : "probe",
                   record.places[i].stop.value_or(record.places[i].probe.value_or(0)) + 1}};
    for (const ShownQuantity quantity : kShownQuantities) {
      if (is_of_stop(quantity) && !record.places[i].stop) continue;
      Json values = Json::array();
      for (const MapCell* cell : cells)
        values.push_back(cell->amplitudes ? json_maybe(shown_value({quantity, i}, record.places,
                                                                   *cell->amplitudes))
                                          : Json(nullptr));
      std::string key = name_of(quantity);
      std::replace(key.begin(), key.end(), '-', '_');
      place[key] = values;
    }
    list.push_back(place);
  }
  return list;
}

}  // namespace

std::string to_json(const MapRecord& record) {
  const AttractorMap& map = record.map;
  Json document = document_head(record.info, record.outcome, record.warnings);
  document["x"] = axis_json(map.options.x, record.x_unit);
  document["y"] = axis_json(map.options.y, record.y_unit);
  document["nearness"] = map.options.nearness;
  document["attractors"] = Json::array();
  for (std::size_t i = 0; i < map.attractors.size(); ++i)
    document["attractors"].push_back(attractor_json(map, i));
  Json status = Json::array(), attractor = Json::array(), impacts = Json::array(),
       speed = Json::array(), stuck = Json::array(), exponent = Json::array();
  const std::vector<const MapCell*> told = told_cells(map.cells, document);
  for (const MapCell* cell : told) {
    status.push_back(name_of(cell->attractor.status));
    attractor.push_back(cell->place >= 0 ? Json(cell->place + 1) : Json(nullptr));
    impacts.push_back(json_number(cell_value(*cell, MapQuantity::kImpacts)));
    speed.push_back(json_number(cell_value(*cell, MapQuantity::kSpeed)));
    stuck.push_back(json_number(cell_value(*cell, MapQuantity::kStuck)));
    exponent.push_back(json_maybe(cell->exponent));
  }
  Json& cells = document["cells"];
  cells["status"] = std::move(status);
  cells["attractor"] = std::move(attractor);
  cells["impacts_per_period"] = std::move(impacts);
  cells["peak_speed"] = std::move(speed);
  cells["stuck_part"] = std::move(stuck);
  if (map.options.exponent_periods > 0) cells["exponent"] = std::move(exponent);
  if (!record.places.empty()) {
    cells["amplitudes"] = measured_json(record, told);
    document["units"] = Json::object();
    add_amplitude_units(record.places, document["units"]);
  }
  if (record.loci) {
    document["loci"] = loci_json(*record.loci);
    document["counters"] = loci_counters_json(*record.loci);
  }
  return document_text(std::move(document), record.info);
}

}  // namespace graze
