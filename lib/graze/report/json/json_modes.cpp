#include "graze/record/detail/modes_record.hpp"
#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_value.hpp"
#include "graze/report/json/json.hpp"

namespace graze {

std::string to_json(const ModesRecord& record) {
  Json document = document_head(record.info, record.outcome, record.warnings);
  const ModeTable& table = record.table;
  document["title"] = record.info.scene_title;
  document["rigid"] = table.rigid;
  Json modes = Json::array();
  for (Eigen::Index j = 0; j < table.omega.size(); ++j)
    modes.push_back({{"mode", j + 1},
                     {"frequency", json_number(table.omega[j])},
                     {"decay_rate", json_number(table.decay[j])},
                     {"residual", table.residuals.size() > 0 ? json_number(table.residuals[j])
                                                             : Json(nullptr)}});
  document["modes"] = modes;
  Json directions = Json::array();
  for (const DirectionShare& share : table.directions)
    directions.push_back({{"direction", share.direction},
                          {"inertia", json_list(share.inertia)},
                          {"effective_masses", json_list(share.inertia.cwiseAbs2())},
                          {"total_mass", json_maybe(share.total_mass)}});
  document["directions"] = directions;
  Json stops = Json::array();
  for (const StopFlexibility& at : table.flexibilities)
    stops.push_back(
        {{"flexibility", json_maybe(at.whole)}, {"flexibility_of_modes", json_number(at.kept)}});
  document["stops"] = stops;
  document["notes"] = table.notes;
  Json mac = nullptr;
  if (record.mac) {
    mac = {{"against", record.mac_file}, {"places", record.mac->common}};
    mac["values"] = Json::array();
    for (Eigen::Index i = 0; i < record.mac->values.rows(); ++i)
      mac["values"].push_back(json_list(Vector(record.mac->values.row(i))));
  }
  document["mac"] = mac;
  return document_text(std::move(document), record.info);
}

}  // namespace graze
