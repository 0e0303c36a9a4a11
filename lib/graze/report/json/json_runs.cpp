// Single runs over a parameter, as documents hold them.
#include "graze/assembly/probes.hpp"
#include "graze/record/detail/run_diagram_record.hpp"
#include "graze/record/detail/sensitivity_record.hpp"
#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_value.hpp"
#include "graze/report/json/json.hpp"

namespace graze {
namespace {

Json run_json(const ValueRun& run) {
  Json impacts = Json::array();
  for (const RunImpact& impact : run.impacts)
    impacts.push_back({{"time", json_number(impact.time)},
                       {"stop", impact.stop + 1},
                       {"speed", json_number(impact.speed)}});
  return {{"value", json_number(run.value)},
          {"reached_end", run.outcome == RunOutcome::kReachedEnd},
          {"impacts", impacts},
          {"peaks", json_list(run.peaks)},
          {"ends", json_list(run.ends)}};
}

Json probes_json(const std::vector<Probe>& probes) {
  Json json = Json::array();
  for (const Probe& probe : probes) json.push_back(probe_json(probe));
  return json;
}

}  // namespace

std::string to_json(const RunDiagramRecord& record) {
  Json document = document_head(record.info, record.outcome, record.warnings);
  document["parameter"] = record.parameter;
  document["unit"] = record.unit;
  document["duration"] = record.duration;
  document["probes"] = probes_json(record.probes);
  document["runs"] = Json::array();
  for (const ValueRun& run : record.runs) document["runs"].push_back(run_json(run));
  return document_text(std::move(document), record.info);
}

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
  return document_text(std::move(document), record.info);
}

}  // namespace graze
