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
  for (const MapCell& cell : map.cells) {
    status.push_back(cell.is_known ? Json(name_of(cell.attractor.status)) : Json(nullptr));
    attractor.push_back(cell.place >= 0 ? Json(cell.place + 1) : Json(nullptr));
    impacts.push_back(json_number(cell_value(cell, MapQuantity::kImpacts)));
    speed.push_back(json_number(cell_value(cell, MapQuantity::kSpeed)));
    stuck.push_back(json_number(cell_value(cell, MapQuantity::kStuck)));
    exponent.push_back(json_maybe(cell.exponent));
  }
  document["cells"] = {{"status", status},
                       {"attractor", attractor},
                       {"impacts_per_period", impacts},
                       {"peak_speed", speed},
                       {"stuck_part", stuck}};
  if (map.options.exponent_periods > 0) document["cells"]["exponent"] = exponent;
  if (record.loci) {
    document["loci"] = loci_json(*record.loci);
    document["counters"] = loci_counters_json(*record.loci);
  }
  return document_text(document);
}

}  // namespace graze
