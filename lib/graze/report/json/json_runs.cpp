#include "graze/report/json/detail/json_runs.hpp"

#include "graze/assembly/probes.hpp"
#include "graze/record/detail/run_diagram_record.hpp"
#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_value.hpp"
#include "graze/report/json/json.hpp"

namespace graze {
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
  for (const Probe& probe : probes)
    json.push_back({{"quantity", probe_quantity_name(probe.quantity)},
                    {"unit", probe_unit(probe.quantity)},
                    {"position", json_number(probe.position)}});
  return json;
}

std::string to_json(const RunDiagramRecord& record) {
  Json document = document_head(record.info, record.outcome, record.warnings);
  document["parameter"] = record.parameter;
  document["unit"] = record.unit;
  document["duration"] = record.duration;
  document["probes"] = probes_json(record.probes);
  document["runs"] = Json::array();
  for (const ValueRun& run : record.runs) document["runs"].push_back(run_json(run));
  return document_text(document);
}

}  // namespace graze
