#include <utility>
#include <vector>

#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_plane.hpp"
#include "graze/report/json/detail/json_value.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/names/detail/comparison_names.hpp"
#include "graze/report/names/detail/sweep_names.hpp"

namespace graze {
namespace {

Json quantity_json(const MotionDifference& difference, ComparedQuantity quantity) {
  if (quantity == ComparedQuantity::kAttractor) return difference.is_same_attractor;
  return json_number(compared_value(difference, quantity));
}

Json difference_json(const MotionDifference& difference) {
  Json json = {{"first", difference.first}};
  for (const ComparedQuantity quantity : kComparedQuantities)
    json[name_of(quantity)] = quantity_json(difference, quantity);
  return json;
}

Json motion_json(const std::string& name, const ComparedMotion& motion) {
  Json impacts = Json::array();
  for (const RunImpact& impact : motion.first)
    impacts.push_back({{"time", impact.time}, {"stop", impact.stop + 1}, {"speed", impact.speed}});
  return {{"name", name},
          {"status", name_of(motion.attractor.status)},
          {"attractor", attractor_label(motion.attractor)},
          {"energy", json_maybe(motion.energy)},
          {"taken", json_maybe(motion.taken)},
          {"first_impacts", impacts},
          {"message", motion.message}};
}

}  // namespace

std::string to_json(const ComparisonRecord& record) {
  Json document = document_head(record.info, record.outcome, record.warnings);
  document["within"] = record.options.within;
  document["motions"] = Json::array();
  for (std::size_t i = 0; i < record.motions.size(); ++i)
    document["motions"].push_back(motion_json(record.names[i], record.motions[i]));
  document["differences"] = Json::array();
  for (const MotionDifference& difference : record.differences)
    document["differences"].push_back(difference_json(difference));
  return document_text(std::move(document), record.info);
}

std::string to_json(const ComparisonMapRecord& record) {
  const ComparisonMap& map = record.map;
  Json document = document_head(record.info, record.outcome, record.warnings);
  document["one"] = record.one;
  document["other"] = record.other;
  document["within"] = map.options.within;
  document["x"] = axis_json(map.options.x, record.x_unit);
  document["y"] = axis_json(map.options.y, record.y_unit);
  const std::vector<const ComparedCell*> told = told_cells(map.cells, document);
  Json& cells = document["cells"];
  Json one = Json::array(), other = Json::array(), messages = Json::array();
  for (const ComparedCell* cell : told) {
    one.push_back(attractor_label(cell->one));
    other.push_back(attractor_label(cell->other));
    messages.push_back(cell->message.empty() ? Json(nullptr) : Json(cell->message));
  }
  cells["one"] = std::move(one);
  cells["other"] = std::move(other);
  cells["message"] = std::move(messages);
  for (const ComparedQuantity quantity : kComparedQuantities) {
    Json values = Json::array();
    for (const ComparedCell* cell : told)
      values.push_back(is_comparable(*cell) ? quantity_json(cell->difference, quantity)
                                            : Json(nullptr));
    cells[name_of(quantity)] = std::move(values);
  }
  return document_text(std::move(document), record.info);
}

}  // namespace graze
