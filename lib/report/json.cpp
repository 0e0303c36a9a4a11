#include "graze/report/json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "graze/report/names.hpp"

namespace graze {
namespace {

using Json = nlohmann::ordered_json;

// Numbers that do not exist (NaN, infinity) are null; JSON has no other word for them.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

template <class T>
Json maybe(const std::optional<T>& value) {
  if (!value) return nullptr;
  if constexpr (std::is_same_v<T, double>)
    return number(*value);
  else
    return *value;
}

Json list(const Vector& v) {
  Json array = Json::array();
  for (const double value : v) array.push_back(number(value));
  return array;
}

Json pair(const Complex& z) { return Json::array({number(z.real()), number(z.imag())}); }

Json header(const RunInfo& info, const Outcome& outcome, const std::vector<std::string>& warnings) {
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

std::string text(const Json& document) {
  // File names and titles may hold bytes that are no UTF-8; they are replaced, not thrown over.
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json multipliers(const Orbit& orbit) {
  Json array = Json::array();
  for (const Eigenvalue& m : orbit.multipliers) array.push_back(pair(m.value));
  return array;
}

Json impacts_at(const Orbit& orbit) {
  Json array = Json::array();
  for (const OrbitImpact& impact : orbit.impacts)
    array.push_back({{"stop", impact.stop + 1},
                     {"period_index", impact.period_index},
                     {"phase", number(impact.phase)},
                     {"speed", number(impact.speed)}});
  return array;
}

Json orbit_json(const Orbit& orbit) {
  Json phases = Json::array(), speeds = Json::array();
  for (const OrbitImpact& impact : orbit.impacts) {
    phases.push_back(number(impact.phase));
    speeds.push_back(number(impact.speed));
  }
  return {{"period", orbit.period},
          {"impacts", orbit.impacts.size()},
          {"phases", phases},
          {"speeds", speeds},
          {"at", impacts_at(orbit)},
          {"multipliers", multipliers(orbit)},
          {"stable", maybe(orbit.stable)},
          {"admissible", orbit.admissible},
          {"clearance", maybe(orbit.clearance)},
          {"residual", number(orbit.residual)},
          {"stuck", false}};
}

Json point_json(const OrbitBranchPoint& point) {
  const OrbitImpact& first = point.orbit.impacts.front();
  Json json = {{"value", number(point.value)},
               {"phase", number(first.phase)},
               {"speed", number(first.speed)},
               {"stable", maybe(point.orbit.stable)},
               {"admissible", point.orbit.admissible},
               {"unstable_multipliers", point.unstable_multipliers},
               {"clearance", maybe(point.orbit.clearance)}};
  if (point.orbit.impacts.size() > 1) json["at"] = impacts_at(point.orbit);
  return json;
}

Json special_json(const SpecialPoint& special) {
  const OrbitImpact& first = special.at.orbit.impacts.front();
  Json json = {{"id", special.id},
               {"label", name_of(special.kind)},
               {"value", number(special.at.value)},
               {"phase", number(first.phase)},
               {"speed", number(first.speed)},
               {"multiplier", special.multiplier ? pair(*special.multiplier) : Json(nullptr)},
               {"admissible", special.at.orbit.admissible}};
  if (special.kind == SpecialKind::kGrazing)
    json["grazing"] = special.by_speed ? "impact speed vanishes" : "interior approach touches";
  return json;
}

}  // namespace

std::string to_json(const CheckRecord& record) {
  Json document = header(record.info, record.outcome, record.warnings);
  const System& system = record.system;
  Json modes = Json::array();
  for (Eigen::Index j = 0; j < system.omega.size(); ++j)
    modes.push_back(
        {{"mode", j + 1},
         {"frequency", number(system.omega[j])},
         {"decay_rate", number(system.delta[j])},
         {"force", system.forcing ? number(system.forcing->amplitude[j]) : Json(nullptr)}});
  document["title"] = record.scene.title;
  document["modes"] = modes;
  document["forcing_period"] = system.forcing ? number(system.period()) : Json(nullptr);
  Json stops = Json::array();
  for (const RigidStop& stop : system.stops)
    stops.push_back({{"gap", number(stop.gap)},
                     {"restitution", number(stop.restitution)},
                     {"row", list(stop.row)},
                     {"direction", list(stop.direction)},
                     {"effective_mass", number(1.0 / stop.row.squaredNorm())}});
  document["stops"] = stops;
  document["collocation_condition"] =
      record.collocation_condition > 0.0 ? number(record.collocation_condition) : Json(nullptr);
  document["flow"] = "exact";
  return text(document);
}

std::string to_json(const SimulationRecord& record) {
  Json document = header(record.info, record.outcome, record.warnings);
  Json events = Json::array();
  for (const Event& event : record.events)
    events.push_back({{"kind", name_of(event.kind)},
                      {"time", number(event.time)},
                      {"stop", event.stop + 1},
                      {"speed", number(event.speed)},
                      {"phase", maybe(event.phase)},
                      {"energy_change", number(event.energy_change)}});
  document["units"] = {
      {"time", "s"},     {"speed", "m/s"},       {"phase", "rad"}, {"energy_change", "J"},
      {"q", "kg^1/2 m"}, {"qdot", "kg^1/2 m/s"}, {"gap", "m"}};
  document["events"] = events;
  const Simulation& run = record.run;
  Json stuck = Json::array();
  if (run.resting_stop) stuck.push_back(*run.resting_stop + 1);
  document["final"] = {{"time", number(run.end_time)},
                       {"q", list(run.final.q)},
                       {"qdot", list(run.final.qdot)},
                       {"stuck", stuck}};
  document["totals"] = {{"impacts", run.totals.impacts},
                        {"stuck_time", number(run.totals.stuck_time)},
                        {"energy_added_by_impacts", number(run.totals.energy_added)},
                        {"energy_lost_by_impacts", number(run.totals.energy_lost)},
                        {"smallest_gap", maybe(run.totals.smallest_gap)},
                        {"undecided_touches", run.totals.undecided_touches}};
  return text(document);
}

std::string to_json(const OrbitRecord& record) {
  Json document = header(record.info, record.outcome, record.warnings);
  Json orbits = Json::array();
  for (const Orbit& orbit : record.found.orbits) orbits.push_back(orbit_json(orbit));
  document["units"] = {{"phase", "rad"}, {"speed", "m/s"}, {"clearance", "m"}, {"residual", "1"}};
  document["orbits"] = orbits;
  const auto count = [](const StartCount& c) {
    return Json{{"tried", c.tried}, {"converged", c.converged}};
  };
  document["starts"] = {{"closed_form", count(record.found.closed_form)},
                        {"simulation", count(record.found.simulation)},
                        {"random", count(record.found.random)}};
  document["left_out_as_inadmissible"] = record.found.inadmissible;
  document["notes"] = record.found.notes;
  return text(document);
}

std::string to_json(const BranchRecord& record) {
  Json document = header(record.info, record.outcome, record.warnings);
  document["parameter"] = record.traced.parameter;
  document["units"] = {
      {"value", record.unit}, {"phase", "rad"}, {"speed", "m/s"}, {"clearance", "m"}};
  Json branches = Json::array();
  for (const OrbitBranch& branch : record.traced.branches) {
    Json points = Json::array(), special = Json::array();
    for (const OrbitBranchPoint& point : branch.points) points.push_back(point_json(point));
    for (const SpecialPoint& s : branch.special) special.push_back(special_json(s));
    branches.push_back({{"id", branch.id},
                        {"component", branch.component},
                        {"period", branch.points.front().orbit.period},
                        {"impacts", branch.points.front().orbit.impacts.size()},
                        {"ends", {name_of(branch.ends[0]), name_of(branch.ends[1])}},
                        {"points", points},
                        {"special", special}});
  }
  document["branches"] = branches;
  document["loci"] = Json::array();
  document["counters"] = {{"starts", record.traced.starts},
                          {"surveyed_values", record.traced.surveyed_values},
                          {"traces", record.traced.traced},
                          {"traces_cut_short", record.traced.cut_short},
                          {"shooting_evaluations", record.traced.shooting_evaluations},
                          {"rejected_steps", record.traced.rejected_steps}};
  document["notes"] = record.traced.notes;
  return text(document);
}

}  // namespace graze
