#include "graze/report/json/detail/json_document.hpp"

#include "graze/base/terminal_text.hpp"
#include "graze/record/described/detail/shared_parts.hpp"
#include "graze/report/json/detail/document_writer.hpp"

namespace graze {
namespace {

// Empties every unit in a document.
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
  DocumentWriter writer;
  describe_head(writer, info, outcome, warnings);
  return writer.take();
}

std::string document_text(Json document, const RunInfo& info) {
  if (info.units == Units::kNone) remove_units(document);
  return document_text(document);
}

std::string document_text(const Json& document) {
  return terminal_json(document.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace graze
