#include "graze/record/detail/sensitivity_record.hpp"
#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_runs.hpp"
#include "graze/report/json/detail/json_value.hpp"
#include "graze/report/json/json.hpp"

namespace graze {
std::string to_json(const SensitivityRecord& record) {
  Json document = document_head(record.info, record.outcome, record.warnings);
  document["parameter"] = record.parameter;
  document["unit"] = record.unit;
  document["second"] = record.second.empty() ? Json(nullptr) : Json(record.second);
  document["second_unit"] = record.second.empty() ? Json(nullptr) : Json(record.second_unit);
  document["reference"] = json_number(record.reference);
  document["probes"] = probes_json(record.probes);
  document["curves"] = Json::array();
  for (const SensitivityCurve& curve : record.curves) {
    Json points = Json::array();
    for (std::size_t k = 0; k < curve.runs.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(k);
      Json point = run_json(curve.runs[k]);
      point["s1"] = json_list(curve.s1.row(at));
      point["s2"] = json_list(curve.s2.row(at));
      points.push_back(point);
    }
    document["curves"].push_back(
        {{"second", record.second.empty() ? Json(nullptr) : json_number(curve.second)},
         {"points", points},
         {"reference", run_json(curve.reference)}});
  }
  return document_text(document);
}

}  // namespace graze
