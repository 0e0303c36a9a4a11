#include "graze/report/json/json.hpp"

#include <algorithm>

#include "graze/bifurcation/problem/detail/special_names.hpp"
#include "graze/report/detail/names.hpp"
#include "graze/report/json/detail/json_amplitudes.hpp"
#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_value.hpp"
#include "graze/report/names/detail/sweep_names.hpp"
#include "graze/system/detail/hub_state.hpp"

namespace graze {
namespace {

Json pair(const Complex& z) { return Json::array({json_number(z.real()), json_number(z.imag())}); }

Json multipliers(const Orbit& orbit) {
  Json array = Json::array();
  for (const Eigenvalue& m : orbit.multipliers) array.push_back(pair(m.value));
  return array;
}

Json impacts_at(const Orbit& orbit) {
  Json array = Json::array();
  for (const OrbitImpact& impact : orbit.impacts) {
    array.push_back({{"stop", impact.stop + 1},
                     {"period_index", impact.period_index},
                     {"phase", json_number(impact.phase)},
                     {"speed", json_number(impact.speed)}});
    if (!impact.contact || !(impact.contact->duration > 0.0)) continue;
    const OrbitContact& contact = *impact.contact;
    array.back().update({{"duration", json_number(contact.duration)},
                         {"peak_force", json_number(contact.peak_force)},
                         {"effective_restitution", json_number(contact.speed_after / impact.speed)},
                         {"energy_change", json_number(-contact.taken)}});
  }
  return array;
}

Json instant_json(const OrbitInstant& at) {
  return {{"period_index", at.period_index}, {"phase", json_number(at.phase)}};
}

// The first state of an orbit that was followed: the motion from there repeats it.
void add_section(const Orbit& orbit, Json& json) {
  if (!orbit.section) return;
  Json section = instant_json(orbit.section->at);
  section["q"] = json_list(orbit.section->states.front().q);
  section["qdot"] = json_list(orbit.section->states.front().qdot);
  json["section"] = section;
}

void add_sticking(const Orbit& orbit, Json& json) {
  if (!orbit.sticks()) return;
  Json phases = Json::array();
  for (const StickingPhase& sticking : orbit.sticking)
    phases.push_back({{"stop", sticking.stop + 1},
                      {"from", instant_json(sticking.from)},
                      {"to", instant_json(sticking.to)},
                      {"duration", json_number(sticking.duration)},
                      {"force", json_number(sticking.force)},
                      {"smallest_force", json_maybe(sticking.smallest_force)}});
  json["stuck_phases"] = phases;
  add_section(orbit, json);
  json["closure_speed"] = json_number(orbit.section->closure_speed);
}

Json orbit_json(const Orbit& orbit) {
  Json phases = Json::array(), speeds = Json::array();
  for (const OrbitImpact& impact : orbit.impacts) {
    phases.push_back(json_number(impact.phase));
    speeds.push_back(json_number(impact.speed));
  }
  Json json = {{"period", orbit.period},
               {"impacts", orbit.impacts.size()},
               {"phases", phases},
               {"speeds", speeds},
               {"at", impacts_at(orbit)},
               {"multipliers", multipliers(orbit)},
               {"stable", json_maybe(orbit.stable)},
               {"admissible", orbit.admissible},
               {"clearance", json_maybe(orbit.clearance)},
               {"residual", json_number(orbit.residual)},
               {"stuck", orbit.sticks()}};
  orbit.sticks() ? add_sticking(orbit, json) : add_section(orbit, json);
  return json;
}

// Of the first impact; null where the orbit has none, at rest on its stop.
Json first_phase(const Orbit& orbit) {
  return orbit.impacts.empty() ? Json(nullptr) : json_number(orbit.impacts.front().phase);
}

Json first_speed(const Orbit& orbit) {
  return orbit.impacts.empty() ? Json(nullptr) : json_number(orbit.impacts.front().speed);
}

Json point_json(const OrbitBranchPoint& point) {
  Json json = {{"value", json_number(point.value)},
               {"phase", first_phase(point.orbit)},
               {"speed", first_speed(point.orbit)},
               {"stable", json_maybe(point.orbit.stable)},
               {"admissible", point.orbit.admissible},
               {"unstable_multipliers", point.unstable_multipliers},
               {"clearance", json_maybe(point.orbit.clearance)}};
  if (point.orbit.impacts.size() > 1) json["at"] = impacts_at(point.orbit);
  json["stuck"] = point.orbit.sticks();
  if (point.orbit.sticks()) {
    json["impacts"] = point.orbit.impacts.size();
    json["multipliers"] = multipliers(point.orbit);
    add_sticking(point.orbit, json);
  }
  return json;
}

// From 1, in the order of the impacts, or of the stuck phases.
Json stops_of(const std::vector<int>& order) {
  Json stops = Json::array();
  for (const int stop : order) stops.push_back(stop + 1);
  return stops;
}

Json special_json(const SpecialPoint& special) {
  const std::optional<SpecialPoint::Impact> impact = special.impact();
  Json json = {{"id", special.id},
               {"label", label_of(special.kind)},
               {"value", json_number(special.at.value)},
               {"phase", impact ? json_number(impact->phase) : Json(nullptr)},
               {"speed", impact ? json_number(impact->speed) : Json(nullptr)},
               {"multiplier", special.multiplier ? pair(*special.multiplier) : Json(nullptr)},
               {"admissible", special.at.orbit.admissible}};
  if (const std::optional<Bracket>& bracket = special.solution.bracket) {
    json["bracket"] = {json_number(bracket->from), json_number(bracket->to)};
    json["converged"] = bracket->converged;
  }
  if (special.at.orbit.impacts.size() > 1) json["at"] = impacts_at(special.at.orbit);
  add_sticking(special.at.orbit, json);
  if (special.kind == SpecialKind::kChatterCompletes)
    json["chatter"] =
        special.interrupted ? "a stuck phase is cut in two" : "completes at its release";
  if (special.kind == SpecialKind::kGrazing)
    json["grazing"] = special.by_push    ? "departure is pushed back"
                      : special.by_speed ? "impact speed vanishes"
                                         : "interior approach touches";
  return json;
}

Json event_json(const Event& event) {
  Json json = {
      {"kind", name_of(event.kind)}, {"time", json_number(event.time)}, {"stop", event.stop + 1}};
  switch (event.kind) {
    case EventKind::kImpact:
      json["speed"] = json_number(event.speed);
      json["phase"] = json_maybe(event.phase);
      json["energy_change"] = json_number(event.energy_change);
      break;
    case EventKind::kChatter:
      json.update(
          {{"impacts", event.impacts}, {"closure_speed", json_number(event.closure_speed)}});
      json["energy_change"] = json_number(event.energy_change);
      break;
    case EventKind::kStick:
      json["force"] = json_number(event.force);
      break;
    case EventKind::kContact:
      json.update({{"speed", json_number(event.speed)}, {"phase", json_maybe(event.phase)}});
      break;
    case EventKind::kSeparation:
      json.update({{"speed", json_number(event.speed)}, {"duration", json_number(event.duration)}});
      json.update({{"peak_force", json_number(event.peak_force)},
                   {"effective_restitution", json_maybe(event.effective_restitution)},
                   {"energy_change", json_number(event.energy_change)}});
      break;
    case EventKind::kRelease:
      break;
  }
  return json;
}

Json final_json(const System& system, const Simulation& run) {
  Json stuck = Json::array(), forces = Json::array();
  for (const int stop : run.stuck) stuck.push_back(stop + 1);
  for (const double force : run.forces) forces.push_back(json_number(force));
  Json json = {{"time", json_number(run.end_time)},
               {"q", json_list(run.final.q)},
               {"qdot", json_list(run.final.qdot)},
               {"stuck", stuck},
               {"forces", forces}};
  if (!system.turns()) return json;
  const HubState hub = hub_state(*system.rotation(), run.final);
  json["q"] = json_list(hub.beam.q);
  json["qdot"] = json_list(hub.beam.qdot);
  json["angle"] = json_number(hub.angle);
  json["rate"] = json_number(hub.rate);
  return json;
}

Json totals_json(const RunTotals& totals) {
  return {{"impacts", totals.impacts},
          {"chatters", totals.chatters},
          {"stuck_time", json_number(totals.stuck_time)},
          {"energy_added_by_impacts", json_number(totals.energy_added)},
          {"energy_lost_by_impacts", json_number(totals.energy_lost)},
          {"smallest_gap", json_maybe(totals.smallest_gap)},
          {"undecided_touches", totals.undecided_touches},
          {"clamped_restitutions", totals.clamped_restitutions}};
}

Json energy_json(const System& system, const EnergyBalance& balance) {
  const EnergyEntries entries = energy_entries(system, balance);
  Json json = {{"start", json_number(balance.start)},
               {"forcing", json_maybe(entries.forcing)},
               {"load", json_maybe(entries.load)},
               {"constraint", json_maybe(entries.constraint)},
               {"impacts", json_maybe(entries.impacts)},
               {"dissipation", json_maybe(entries.dissipation)},
               {"end", json_number(balance.now)},
               {"defect", json_number(balance.defect())},
               {"relative_defect", json_number(relative_defect(balance))}};
  if (entries.contact) json["contact"] = json_number(*entries.contact);
  return json;
}

// How the components of (p, 1) solutions were sought.
Json search_json(const OrbitBranches& traced) {
  const ComponentSearch& search = traced.sought;
  const auto spacing = [](double width) { return width > 0.0 ? Json(width) : Json(nullptr); };
  return {{"complete", search.complete()},
          {"intervals", search.surveys > 0 ? Json(search.ranges) : Json(nullptr)},
          {"evaluations", search.evaluations},
          {"undecided", search.undecided},
          {"widest_undecided", spacing(search.widest)},
          {"starts_lost", search.lost},
          {"cells", search.cells},
          {"undecided_cells", search.undecided_cells},
          {"widest_undecided_cell", spacing(search.widest_cell)},
          {"resolution", spacing(search.resolution)},
          {"runs_lost", search.runs_lost},
          {"judged_values", search.samples},
          {"judged_spacing", spacing(search.sample_spacing)},
          {"solved_values", search.solved_values},
          {"solved_spacing", spacing(search.solved_spacing)},
          {"unsolved_values", search.unsolved},
          {"start_values", search.start_values},
          {"start_spacing", spacing(search.start_spacing)},
          {"random_starts", search.random_starts}};
}

}  // namespace

void add_event_json(const Event& event, Spool& events) {
  const std::string entry = event_json(event).dump(1);
  std::string text = events.empty() ? "\n" : ",\n";
  // Two levels deep in the document, so every line begins with two more blanks.
  for (std::size_t start = 0; start < entry.size();) {
    const std::size_t end = std::min(entry.find('\n', start), entry.size() - 1) + 1;
    text += "  ";
    text.append(entry, start, end - start);
    start = end;
  }
  events.append(text);
}

Json section_json(const RunSection& section) {
  const bool of_impacts = section.kind() == DiagramSection::kImpact;
  Json time = Json::array(), stop = Json::array(), across = Json::array(), up = Json::array();
  for (const SectionPoint& point : section.points()) {
    time.push_back(json_number(point.time));
    stop.push_back(point.stop + 1);
    across.push_back(json_number(point.across));
    up.push_back(json_number(point.up));
  }
  return {{"kind", name_of(section.kind())},
          {"from", section.from()},
          {"points", section.points().size()},
          {"left_out", section.left_out()},
          {"time", time},
          {"stop", stop},
          {of_impacts ? "phase" : "displacement", across},
          {of_impacts ? "speed" : "velocity", up}};
}

Document to_json(const SimulationRecord& record, Spool& events) {
  Json document = document_head(record.info, record.outcome, record.warnings);
  if (!record.notes.empty()) document["notes"] = record.notes;
  document["units"] = {{"time", "s"},          {"speed", "m/s"},         {"phase", "rad"},
                       {"energy_change", "J"}, {"closure_speed", "m/s"}, {"force", "N"},
                       {"q", "kg^1/2 m"},      {"qdot", "kg^1/2 m/s"},   {"gap", "m"},
                       {"energy", "J"}};
  for (std::size_t i = 0; i < record.probes.size(); ++i)
    document["units"]["probe_" + std::to_string(i + 1)] = probe_unit(record.probes[i].quantity);
  document["events"] = Json::array();
  document["final"] = final_json(record.system, record.run);
  document["totals"] = totals_json(record.run.totals);
  if (record.run.energy) document["energy"] = energy_json(record.system, *record.run.energy);
  if (record.run.amplitudes) {
    add_amplitudes(record.places, *record.run.amplitudes, document);
    document["measured_time"] = json_number(record.run.amplitudes->duration);
    add_amplitude_units(record.places, document["units"]);
    add_load_units(document["units"]);
  }
  if (record.section) document["section"] = section_json(*record.section);
  const std::string whole = document_text(std::move(document), record.info);
  // Quotes inside strings are escaped, so this is found once, where it stands.
  const std::string opening = "\n \"events\": [";
  const std::size_t at = whole.find(opening + "]") + opening.size();
  return {whole.substr(0, at), events, (events.empty() ? "" : "\n ") + whole.substr(at)};
}

std::string to_json(const OrbitRecord& record) {
  Json document = document_head(record.info, record.outcome, record.warnings);
  Json orbits = Json::array();
  for (std::size_t i = 0; i < record.found.orbits.size(); ++i) {
    orbits.push_back(orbit_json(record.found.orbits[i]));
    add_amplitudes(record.places, record.amplitudes[i], orbits.back());
  }
  document["units"] = {{"phase", "rad"},  {"speed", "m/s"},      {"clearance", "m"},
                       {"residual", "1"}, {"duration", "s"},     {"force", "N"},
                       {"q", "kg^1/2 m"}, {"qdot", "kg^1/2 m/s"}};
  add_amplitude_units(record.places, document["units"]);
  document["orbits"] = orbits;
  const auto count = [](const StartCount& c) {
    return Json{{"tried", c.tried}, {"converged", c.converged}};
  };
  document["starts"] = {{"closed_form", count(record.found.closed_form)},
                        {"two_impacts", count(record.found.two_impacts)},
                        {"simulation", count(record.found.simulation)},
                        {"random", count(record.found.random)},
                        {"global", count(record.found.global)}};
  document["patterns_searched"] = record.found.patterns;
  document["left_out_as_inadmissible"] = record.found.inadmissible;
  document["notes"] = all_notes(record.found.notes, record.found.details);
  return document_text(std::move(document), record.info);
}

std::string to_json(const BranchRecord& record) {
  Json document = document_head(record.info, record.outcome, record.warnings);
  document["parameter"] = record.traced.parameter;
  document["units"] = {{"value", record.unit}, {"phase", "rad"},       {"speed", "m/s"},
                       {"clearance", "m"},     {"duration", "s"},      {"force", "N"},
                       {"q", "kg^1/2 m"},      {"qdot", "kg^1/2 m/s"}, {"closure_speed", "m/s"}};
  add_amplitude_units(record.amplitudes.places, document["units"]);
  Json branches = Json::array();
  for (const OrbitBranch& branch : record.traced.branches) {
    Json points = Json::array(), special = Json::array();
    for (const OrbitBranchPoint& point : branch.points) points.push_back(point_json(point));
    for (const SpecialPoint& s : branch.special) special.push_back(special_json(s));
    if (!record.amplitudes.empty()) {
      const auto& measured = record.amplitudes.branches[branches.size()];
      for (std::size_t k = 0; k < points.size(); ++k)
        add_amplitudes(record.amplitudes.places, measured.points[k], points[k]);
      for (std::size_t k = 0; k < special.size(); ++k)
        add_amplitudes(record.amplitudes.places, measured.special[k], special[k]);
    }
    branches.push_back(
        {{"id", branch.id},
         {"component", branch.component},
         {"period", branch.pattern.period},
         {"impacts", branch.sticks() ? Json(nullptr) : Json(branch.pattern.impacts())},
         {"stops", stops_of(branch.sticks() ? branch.sticking : branch.pattern.stops)},
         {"stuck", branch.sticks()},
         {"origin", branch.origin.empty() ? Json(nullptr) : Json(branch.origin)},
         {"ends", {name_of(branch.ends[0]), name_of(branch.ends[1])}},
         {"points", points},
         {"special", special}});
  }
  document["branches"] = branches;
  document["loci"] = Json::array();
  document["counters"] = {
      {"starts", record.traced.starts},
      {"virtual_starts", record.traced.virtual_starts},
      {"surveyed_values", record.traced.sought.evaluations + record.traced.sought.samples},
      {"traces", record.traced.traced},
      {"traces_cut_short", record.traced.cut_short},
      {"shooting_evaluations", record.traced.shooting_evaluations},
      {"rejected_steps", record.traced.rejected_steps},
      {"switched", record.traced.switched},
      {"left_open", record.traced.left_open}};
  document["search"] = search_json(record.traced);
  document["notes"] = all_notes(record.traced.notes, record.traced.details);
  return document_text(std::move(document), record.info);
}

}  // namespace graze
