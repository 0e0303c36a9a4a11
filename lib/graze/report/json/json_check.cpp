#include "graze/assembly/detail/requested_restitution.hpp"
#include "graze/assembly/detail/spring_law.hpp"
#include "graze/assembly/mode_table.hpp"
#include "graze/assembly/probes.hpp"
#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_value.hpp"
#include "graze/report/json/json.hpp"
#include "graze/structure/modal_model.hpp"
#include "graze/study/cost/detail/step_choice.hpp"
#include "graze/system/detail/hub_state.hpp"

namespace graze {
namespace {

// A number, or the list a0, a1, .. of one that depends on the speed.
Json restitution(const Restitution& r) {
  if (r.is_constant()) return r.at_rest();
  return r.coefficients();
}

Json maybe_restitution(const Spring& spring) {
  const std::optional<RequestedRestitution> asked = requested_restitution(spring);
  if (!asked) return nullptr;
  return {{"requested", json_number(asked->requested)},
          {"speed", json_maybe(asked->speed)},
          {"mass", json_maybe(asked->mass)},
          {"effective", json_number(asked->effective)},
          {"exact_coefficient", json_maybe(asked->exact_coefficient)}};
}

Json spring(const ContactForce& law, const Spring& from) {
  return {{"stiffness", json_number(law.stiffness)},
          {"exponent", json_number(law.exponent)},
          {"coefficient", json_number(law.coefficient)},
          {"residual", from.is_residual},
          {"restitution", maybe_restitution(as_given(from, law.stiffness))}};
}

Json torque_json(const Torque& torque) {
  if (const auto* pulse = std::get_if<TorquePulse>(&torque))
    return {{"kind", "pulse"},
            {"amplitude", json_number(pulse->amplitude)},
            {"duration", json_number(pulse->duration)}};
  const auto& table = std::get<TorqueTable>(torque);
  return {{"kind", "table"}, {"times", table.times}, {"values", table.values}};
}

Json hub_json(const Hub& hub) {
  return {{"radius", json_number(hub.radius)},
          {"inertia", json_number(hub.inertia)},
          {"torque", hub.torque ? torque_json(*hub.torque) : Json(nullptr)},
          {"equations", hub.equations == HubEquations::kConsistent ? "consistent" : "paper"},
          {"centrifugal", hub.centrifugal},
          {"friction", json_maybe(hub.friction)}};
}

Json elements_json(const std::optional<ElementAccuracy>& found) {
  if (!found) return nullptr;
  return {{"elements", found->elements},
          {"order", found->order},
          {"rigid_motions", found->rigid},
          {"change", json_number(found->change)},
          {"change_beyond", json_number(found->change_beyond)}};
}

Json probes_json(const Scene& scene, const System& system) {
  Json probes = Json::array();
  const std::vector<ProbeRow> rows = probe_rows(scene, system);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    probes.push_back(probe_json(scene.probes[i]));
    probes.back()["row"] = json_list(rows[i].row);
  }
  return probes;
}

}  // namespace

std::string to_json(const CheckRecord& record) {
  Json document = document_head(record.info, record.outcome, record.warnings);
  const System& system = record.system;
  Json modes = Json::array();
  const Vector decay = decay_rates(system);
  for (Eigen::Index j = 0; j < system.omega.size(); ++j)
    modes.push_back(
        {{"mode", j + 1},
         {"frequency", json_number(system.omega[j])},
         {"decay_rate", json_number(decay[j])},
         {"force", system.forcing() ? json_number(system.forcing()->amplitude[j]) : Json(nullptr)},
         {"load", system.load() ? json_number((*system.load())[j]) : Json(nullptr)}});
  document["title"] = record.scene.title;
  document["modes"] = modes;
  document["elements"] = elements_json(record.model.elements);
  document["forcing_period"] = system.forcing() ? json_number(system.period()) : Json(nullptr);
  document["gravity"] =
      record.scene.gravity ? json_number(record.scene.gravity->acceleration) : Json(nullptr);
  Json stops = Json::array();
  const std::vector<StopFlexibility> flexibilities = stop_flexibilities(record.scene, record.model);
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    const Stop& stop = system.stops[i];
    const std::optional<Spring>& from = record.scene.stops[i].spring;
    stops.push_back(
        {{"gap", json_number(stop.gap)},
         {"gap_shift", json_number(stop.gap - record.scene.stops[i].gap)},
         {"restitution", stop.is_compliant() ? Json(nullptr) : restitution(stop.restitution())},
         {"spring", stop.is_compliant() ? spring(stop.force(), *from) : Json(nullptr)},
         {"row", json_list(stop.row)},
         {"direction", json_list(stop.direction())},
         {"effective_mass", json_number(1.0 / stop.row.squaredNorm())},
         {"flexibility", json_maybe(flexibilities[i].whole)},
         {"flexibility_of_modes", json_number(flexibilities[i].kept)}});
  }
  document["stops"] = stops;
  document["probes"] = probes_json(record.scene, record.system);
  document["hub"] = record.scene.hub ? hub_json(*record.scene.hub) : Json(nullptr);
  document["collocation_condition"] = record.collocation_condition > 0.0
                                          ? json_number(record.collocation_condition)
                                          : Json(nullptr);
  document["closure_speed"] = json_maybe(record.closure_speed);
  const FlowDecision decision = flow_decision(record.scene);
  document["flow"] = flow_name(decision.flow);
  document["flow_reason"] = decision.reason;
  document["step"] = json_maybe(record.scene.solver.step);
  document["longest_stable_step"] =
      record.steps ? json_number(record.steps->longest) : Json(nullptr);
  return document_text(std::move(document), record.info);
}

}  // namespace graze
