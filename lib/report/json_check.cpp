#include <cmath>
#include <nlohmann/json.hpp>

#include "graze/assembly/probes.hpp"
#include "graze/assembly/requested_restitution.hpp"
#include "graze/report/json.hpp"
#include "graze/study/step_choice.hpp"
#include "graze/system/hub_state.hpp"

namespace graze {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json maybe(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

Json list(const Vector& v) {
  Json array = Json::array();
  for (const double value : v) array.push_back(number(value));
  return array;
}

// A number, or the list a0, a1, .. of one that depends on the speed.
Json restitution(const Restitution& r) {
  if (r.is_constant()) return r.at_rest();
  return r.coefficients();
}

Json maybe_restitution(const Spring& spring) {
  const std::optional<RequestedRestitution> asked = requested_restitution(spring);
  if (!asked) return nullptr;
  return {{"requested", number(asked->requested)},
          {"speed", maybe(asked->speed)},
          {"mass", maybe(asked->mass)},
          {"effective", number(asked->effective)},
          {"exact_coefficient", maybe(asked->exact_coefficient)}};
}

Json spring(const ContactForce& law, const Spring& from) {
  return {{"stiffness", number(law.stiffness)},
          {"exponent", number(law.exponent)},
          {"coefficient", number(law.coefficient)},
          {"restitution", maybe_restitution(from)}};
}

Json torque_json(const Torque& torque) {
  if (const auto* pulse = std::get_if<TorquePulse>(&torque))
    return {{"kind", "pulse"},
            {"amplitude", number(pulse->amplitude)},
            {"duration", number(pulse->duration)}};
  const auto& table = std::get<TorqueTable>(torque);
  return {{"kind", "table"}, {"times", table.times}, {"values", table.values}};
}

Json hub_json(const Hub& hub) {
  return {{"radius", number(hub.radius)},
          {"inertia", number(hub.inertia)},
          {"torque", hub.torque ? torque_json(*hub.torque) : Json(nullptr)},
          {"equations", hub.equations == HubEquations::kConsistent ? "consistent" : "paper"},
          {"centrifugal", hub.centrifugal},
          {"friction", maybe(hub.friction)}};
}

Json probes_json(const Scene& scene, const System& system) {
  Json probes = Json::array();
  const std::vector<ProbeRow> rows = probe_rows(scene, system);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    probes.push_back({{"quantity", probe_quantity_name(rows[i].quantity)},
                      {"unit", probe_unit(rows[i].quantity)},
                      {"position", scene.beam() && !is_of_hub(rows[i].quantity)
                                       ? number(scene.probes[i].position)
                                       : Json(nullptr)},
                      {"row", list(rows[i].row)}});
  }
  return probes;
}

}  // namespace

std::string to_json(const CheckRecord& record) {
  Json document = Json::parse(json_head(record.info, record.outcome, record.warnings));
  const System& system = record.system;
  Json modes = Json::array();
  const Vector decay = decay_rates(system);
  for (Eigen::Index j = 0; j < system.omega.size(); ++j)
    modes.push_back(
        {{"mode", j + 1},
         {"frequency", number(system.omega[j])},
         {"decay_rate", number(decay[j])},
         {"force", system.forcing ? number(system.forcing->amplitude[j]) : Json(nullptr)},
         {"load", system.load ? number((*system.load)[j]) : Json(nullptr)}});
  document["title"] = record.scene.title;
  document["modes"] = modes;
  document["forcing_period"] = system.forcing ? number(system.period()) : Json(nullptr);
  document["gravity"] =
      record.scene.gravity ? number(record.scene.gravity->acceleration) : Json(nullptr);
  Json stops = Json::array();
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    const RigidStop& stop = system.stops[i];
    const std::optional<Spring>& from = record.scene.stops[i].spring;
    stops.push_back({{"gap", number(stop.gap)},
                     {"restitution", stop.spring ? Json(nullptr) : restitution(stop.restitution)},
                     {"spring", stop.spring ? spring(*stop.spring, *from) : Json(nullptr)},
                     {"row", list(stop.row)},
                     {"direction", list(stop.direction)},
                     {"effective_mass", number(1.0 / stop.row.squaredNorm())}});
  }
  document["stops"] = stops;
  document["probes"] = probes_json(record.scene, record.system);
  document["hub"] = record.scene.hub ? hub_json(*record.scene.hub) : Json(nullptr);
  document["collocation_condition"] =
      record.collocation_condition > 0.0 ? number(record.collocation_condition) : Json(nullptr);
  document["closure_speed"] = maybe(record.closure_speed);
  const FlowDecision decision = flow_decision(record.scene);
  document["flow"] = flow_name(decision.flow);
  document["flow_reason"] = decision.reason;
  document["step"] = maybe(record.scene.solver.step);
  document["longest_stable_step"] = record.steps ? number(record.steps->longest) : Json(nullptr);
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace graze
