#include "graze/record/detail/cost_record.hpp"
#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_value.hpp"
#include "graze/report/json/json.hpp"

namespace graze {
namespace {

Json with_error(Json row, const RunError& compared) {
  row["error"] = json_maybe(compared.error);
  row["state_error"] = json_maybe(compared.state_error);
  row["impacts_agree"] = compared.impacts_agree;
  if (!compared.message.empty()) row["message"] = compared.message;
  return row;
}

Json row_json(const FlowCost& row) {
  return with_error({{"flow", row.flow},
                     {"setting", row.setting},
                     {"seconds_per_period", row.seconds_per_period},
                     {"evaluations_per_period", row.evaluations_per_period}},
                    row.compared);
}

Json closure_json(const ClosureCost& row) {
  return with_error({{"closure_speed", row.speed},
                     {"seconds_per_period", row.seconds_per_period},
                     {"impacts_per_period", row.impacts_per_period}},
                    row.compared);
}

Json corrector_json(const CorrectorCosts& costs) {
  Json rows = Json::array();
  for (const CorrectorCost& row : costs.rows)
    rows.push_back({{"predicted", row.predicted},
                    {"steps", row.steps},
                    {"residual", row.residual},
                    {"error", row.error},
                    {"seconds", row.seconds}});
  Json json = {{"orbit", costs.orbit.empty() ? Json(nullptr) : Json(costs.orbit)}, {"rows", rows}};
  if (!costs.message.empty()) json["message"] = costs.message;
  return json;
}

Json contact_json(const ContactOrders& orders) {
  const FirstContact& first = orders.first;
  if (first.stop < 0) return {{"message", first.message}};
  Json lines = Json::array();
  for (const ContactOrder& line : orders.lines) {
    Json rows = Json::array();
    for (const ContactOrderRow& row : line.rows)
      rows.push_back({{"steps", row.steps},
                      {"step", row.step},
                      {"error", row.error},
                      {"seconds", row.seconds},
                      {"evaluations", row.evaluations}});
    const bool stepped = !line.rows.empty() && line.rows.front().steps > 0;
    lines.push_back({{"spring", line.spring},
                     {"method", line.method},
                     {"stiffness", line.contact.stiffness},
                     {"exponent", line.contact.exponent},
                     {"duration", line.contact.duration()},
                     {"order", stepped ? Json(line.order) : Json(nullptr)},
                     {"rows", rows}});
  }
  return {{"stop", first.stop + 1},
          {"mass", first.contact.mass},
          {"speed", first.contact.speed},
          {"depth", first.contact.depth()},
          {"lines", lines}};
}

}  // namespace

std::string to_json(const CostRecord& record) {
  const FlowCosts& costs = record.costs;
  Json document = document_head(record.info, record.outcome, record.warnings);
  document["reference"] = reference_name(costs);
  document["span"] = compared_span(costs, record.info.units);
  if (!costs.reference_message.empty()) document["reference_message"] = costs.reference_message;
  document["impacts"] = costs.impacts;
  document["end_time"] = costs.end_time;
  document["units"] = {{"error", costs.impacts > 0 ? "s" : "1"},
                       {"state_error", "1"},
                       {"seconds_per_period", "s"},
                       {"closure_speed", "m/s"},
                       {"seconds", "s"},
                       {"end_time", "s"}};
  Json rows = Json::array();
  for (const FlowCost& row : costs.rows) rows.push_back(row_json(row));
  document["rows"] = rows;
  document["modes"] = Json::array();
  for (const ModeCost& row : record.modes)
    document["modes"].push_back({{"modes", row.modes},
                                 {"error", json_maybe(row.error)},
                                 {"seconds_per_period", row.seconds_per_period},
                                 {"evaluations_per_period", row.evaluations_per_period}});
  document["closure"] = Json::array();
  for (const ClosureCost& row : record.closure.rows)
    document["closure"].push_back(closure_json(row));
  if (!record.closure.message.empty()) document["closure_message"] = record.closure.message;
  document["corrector"] = corrector_json(record.corrector);
  if (record.contact) document["contact"] = contact_json(*record.contact);
  const FlowCost* best = cheapest(costs, costs.allowed);
  document["recommended"] = {{"tolerance", costs.tolerance},
                             {"allowed_error", costs.allowed},
                             {"flow", best ? Json(best->flow) : Json(nullptr)},
                             {"setting", best ? Json(best->setting) : Json(nullptr)}};
  return document_text(std::move(document), record.info);
}

}  // namespace graze
