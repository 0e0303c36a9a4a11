#include <cmath>
#include <nlohmann/json.hpp>

#include "graze/assembly/probes.hpp"
#include "graze/report/json.hpp"

namespace graze {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json list(const std::vector<double>& values) {
  Json json = Json::array();
  for (const double value : values) json.push_back(number(value));
  return json;
}

Json list(const Matrix& rows, Eigen::Index row) {
  Json json = Json::array();
  for (const double value : rows.row(row)) json.push_back(number(value));
  return json;
}

Json run_json(const ValueRun& run) {
  Json impacts = Json::array();
  for (const RunImpact& impact : run.impacts)
    impacts.push_back({{"time", number(impact.time)},
                       {"stop", impact.stop + 1},
                       {"speed", number(impact.speed)}});
  return {{"value", number(run.value)},
          {"reached_end", run.outcome == RunOutcome::kReachedEnd},
          {"impacts", impacts},
          {"peaks", list(run.peaks)},
          {"ends", list(run.ends)}};
}

}  // namespace

std::string to_json(const SensitivityRecord& record) {
  Json document = Json::parse(json_head(record.info, record.outcome, record.warnings));
  document["parameter"] = record.parameter;
  document["unit"] = record.unit;
  document["second"] = record.second.empty() ? Json(nullptr) : Json(record.second);
  document["second_unit"] = record.second.empty() ? Json(nullptr) : Json(record.second_unit);
  document["reference"] = number(record.reference);
  document["probes"] = Json::array();
  for (const Probe& probe : record.probes)
    document["probes"].push_back({{"quantity", probe_quantity_name(probe.quantity)},
                                  {"unit", probe_unit(probe.quantity)},
                                  {"position", number(probe.position)}});
  document["curves"] = Json::array();
  for (const SensitivityCurve& curve : record.curves) {
    Json points = Json::array();
    for (std::size_t k = 0; k < curve.runs.size(); ++k) {
      Json point = run_json(curve.runs[k]);
      point["s1"] = list(curve.s1, static_cast<Eigen::Index>(k));
      point["s2"] = list(curve.s2, static_cast<Eigen::Index>(k));
      points.push_back(point);
    }
    document["curves"].push_back(
        {{"second", record.second.empty() ? Json(nullptr) : number(curve.second)},
         {"points", points},
         {"reference", run_json(curve.reference)}});
  }
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace graze
