#include "graze/report/json/detail/json_amplitudes.hpp"
#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_value.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/names/detail/sweep_names.hpp"

namespace graze {
namespace {

Json samples_json(const SweepRow& row, DiagramSection section) {
  Json stops = Json::array(), first = Json::array(), second = Json::array();
  if (section == DiagramSection::kImpact) {
    for (const MetImpact& impact : row.motion.impacts) {
      stops.push_back(impact.stop + 1);
      first.push_back(json_number(impact_phase(impact)));
      second.push_back(json_number(impact.speed));
    }
    return {{"stops", stops}, {"phases", first}, {"speeds", second}};
  }
  for (const SweepRow::StopState& state : row.stop_states) {
    stops.push_back(state.stop + 1);
    first.push_back(json_number(state.displacement));
    second.push_back(json_number(state.velocity));
  }
  return {{"stops", stops}, {"displacements", first}, {"velocities", second}};
}

Json row_json(const SweepRow& row, DiagramSection section,
              const std::vector<MeasuredPlace>& places) {
  const AttractorClass attractor = attractor_class(row);
  const bool repeats = attractor.period > 0, sticks = attractor.kind == SettledKind::kSticks;
  Json json = {{"value", json_number(row.value)},
               {"start", name_of(row.start)},
               {"status", name_of(row.status)},
               {"attractor", attractor_label(attractor)},
               {"period", repeats ? Json(attractor.period) : Json(nullptr)},
               {"impacts", repeats && !sticks ? Json(attractor.impacts) : Json(nullptr)},
               {"sticks", row.motion.sticks},
               {"periods", row.motion.periods},
               {"remaining", repeats ? json_number(row.motion.remaining) : Json(nullptr)}};
  if (!row.message.empty()) json["message"] = row.message;
  if (row.exponents) {
    json["exponents"] = json_list(row.exponents->values);
    json["exponent_errors"] = json_list(row.exponents->errors);
    json["lost_exponents"] = row.exponents->lost;
    if (!row.exponents->failure.empty()) json["exponent_message"] = row.exponents->failure;
  }
  json.update(samples_json(row, section));
  if (row.amplitudes) add_amplitudes(places, *row.amplitudes, json);
  return json;
}

}  // namespace

std::string to_json(const DiagramRecord& record) {
  // Numbers survive being written and read again to the last bit.
  Json document = parsed(to_json(record.branches));
  document["units"]["displacement"] = "m";
  document["units"]["velocity"] = "m/s";
  document["units"]["remaining"] = "1";
  document["units"]["exponents"] = "1/s";
  const Sweep& swept = record.swept;
  Json ranges = Json::array(), rows = Json::array();
  for (const AttractorRange& range : attractor_ranges(swept.rows))
    ranges.push_back({{"attractor", attractor_label(range.attractor)},
                      {"from", json_number(swept.rows[range.first].value)},
                      {"to", json_number(swept.rows[range.last].value)},
                      {"values", range.last - range.first + 1}});
  for (const SweepRow& row : swept.rows)
    rows.push_back(row_json(row, record.section, record.branches.amplitudes.places));
  document["sweep"] = {{"section", name_of(record.section)},
                       {"direction", name_of(swept.options.direction)},
                       {"nearness", swept.options.nearness},
                       {"block", Sweep::kBlock},
                       {"run_again", swept.run_again},
                       {"periods", swept.periods},
                       {"impacts", swept.impacts},
                       {"ranges", ranges},
                       {"rows", rows}};
  return document_text(std::move(document), record.branches.info);
}

}  // namespace graze
