#include "graze/report/json/detail/json_document.hpp"

#include <variant>

#include "graze/assembly/probes.hpp"
#include "graze/base/detail/terminal_text.hpp"

namespace graze {
namespace {

// Leaves no unit in a document, wherever it names one.
void remove_units(Json& json) {
  if (json.is_object()) {
    json.erase("units");
    if (json.contains("unit")) json["unit"] = "";
  }
  if (json.is_structured())
    for (Json& part : json) remove_units(part);
}

}  // namespace

Json document_head(const RunInfo& info, const Outcome& outcome,
                   const std::vector<std::string>& warnings) {
  Json options = Json::object();
  for (const auto& [name, value] : info.options)
    std::visit([&, &key = name](const auto& v) { options[key] = v; }, value);
  Json document;
  document["graze"] = {{"version", info.version},
                       {"command", info.command},
                       {"scene", info.scene_file},
                       {"scene_sha256", info.scene_sha256},
                       {"options", options}};
  document["outcome"] = outcome.name;
  if (!outcome.message.empty()) document["message"] = outcome.message;
  if (!warnings.empty()) document["warnings"] = warnings;
  return document;
}

Json probe_json(const Probe& probe) {
  const bool on_beam = probe.shape.empty() && !is_of_hub(probe.quantity);
  return {{"quantity", probe_quantity_name(probe.quantity)},
          {"unit", probe_unit(probe.quantity)},
          {"position", on_beam ? json_number(probe.position) : Json(nullptr)},
          {"node", probe.node.empty() ? Json(nullptr) : Json(probe.node)},
          {"against", probe.against.empty() ? Json(nullptr) : Json(probe.against)}};
}

std::string document_text(Json document, const RunInfo& info) {
  if (info.units == Units::kNone) remove_units(document);
  return document_text(document);
}

std::vector<std::string> all_notes(std::vector<std::string> notes,
                                   const std::vector<std::string>& details) {
  notes.insert(notes.end(), details.begin(), details.end());
  return notes;
}

std::string document_text(const Json& document) {
  return terminal_json(document.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

Json parsed(const std::string& text) { return Json::parse(text); }

}  // namespace graze
