#include "graze/report/csv/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "graze/bifurcation/problem/detail/special_names.hpp"
#include "graze/record/records.hpp"
#include "graze/record/section.hpp"
#include "graze/report/csv/detail/csv_amplitudes.hpp"
#include "graze/report/detail/names.hpp"
#include "graze/system/detail/hub_state.hpp"

namespace graze {

namespace {

std::string csv_cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

// Of the first impact; not a number where the orbit has none, at rest on its stop.
double first_phase(const Orbit& orbit) {
  return orbit.impacts.empty() ? NAN : orbit.impacts.front().phase;
}

double first_speed(const Orbit& orbit) {
  return orbit.impacts.empty() ? NAN : orbit.impacts.front().speed;
}

}  // namespace

std::string events_csv_header() {
  return "kind,time,stop,speed,phase,energy_change,impacts,closure_speed,force,duration,"
         "peak_force,effective_restitution\n";
}

void write_event_row(const Event& e, double* row) {
  const bool meets = e.kind == EventKind::kImpact || e.kind == EventKind::kContact;
  const bool parts = e.kind == EventKind::kSeparation, chatters = e.kind == EventKind::kChatter;
  const auto only = [](bool exists, double value) { return exists ? value : NAN; };
  const std::array<double, kEventNumbers> numbers = {
      e.time,
      e.stop + 1.0,
      only(meets || parts, e.speed),
      only(meets, e.phase.value_or(NAN)),
      only(e.kind == EventKind::kImpact || parts || chatters, e.energy_change),
      only(chatters, static_cast<double>(e.impacts)),
      only(chatters, e.closure_speed),
      only(e.kind == EventKind::kStick, e.force),
      only(parts, e.duration),
      only(parts, e.peak_force),
      only(parts, e.effective_restitution.value_or(NAN))};
  std::copy(numbers.begin(), numbers.end(), row);
}

std::string events_csv_row(const Event& event) {
  std::array<double, kEventNumbers> row{};
  write_event_row(event, row.data());
  std::string text = name_of(event.kind);
  for (const double value : row) fmt::format_to(std::back_inserter(text), ",{}", csv_cell(value));
  return text + "\n";
}

ResultTable events_table(const std::vector<Event>& events) {
  ResultTable table(events_csv_header());
  std::array<double, kEventNumbers> row{};
  for (const Event& event : events) {
    write_event_row(event, row.data());
    table.add(name_of(event.kind));
    for (const double value : row) table.add(value);
  }
  return table;
}

std::vector<std::string> sample_columns(const System& system, bool energy,
                                        const std::vector<ProbeRow>& probes) {
  std::vector<std::string> names = {"time"};
  const auto add = [&](const char* name, std::size_t count) {
    for (std::size_t i = 1; i <= count; ++i) names.push_back(fmt::format("{}{}", name, i));
  };
  if (system.turns()) names.insert(names.end(), {"angle", "rate"});
  const auto modes = static_cast<std::size_t>(system.modes() - (system.turns() ? 1 : 0));
  add("q", modes);
  add("qdot", modes);
  add("gap", system.stops.size());
  add("force", system.stops.size());
  if (energy)
    names.insert(names.end(), {"energy", "work_forcing", "work_load", "work_constraint",
                               "work_impacts", "dissipation", "work_contact"});
  add("probe_", probes.size());
  return names;
}

std::string samples_csv_header(const System& system, bool energy,
                               const std::vector<ProbeRow>& probes) {
  return fmt::format("{}\n", fmt::join(sample_columns(system, energy, probes), ","));
}

std::size_t sample_numbers(const System& system, const Sample& sample,
                           const std::vector<ProbeRow>& probes) {
  constexpr std::size_t kEnergies = 7;
  return 1 + 2 * static_cast<std::size_t>(sample.state.q.size()) + system.stops.size() +
         sample.forces.size() + (sample.energy ? kEnergies : 0) + probes.size();
}

double* write_sample_row(const System& system, const Sample& sample,
                         const std::vector<ProbeRow>& probes, double* row) {
  const auto add = [&](const std::optional<double>& value) { *row++ = value.value_or(NAN); };
  const auto add_state = [&](const State& state) {
    row = std::copy(state.q.begin(), state.q.end(), row);
    row = std::copy(state.qdot.begin(), state.qdot.end(), row);
  };
  *row++ = sample.time;
  if (system.turns()) {
    const HubState hub = hub_state(*system.rotation(), sample.state);
    *row++ = hub.angle;
    *row++ = hub.rate;
    add_state(hub.beam);
  } else {
    add_state(sample.state);
  }
  for (const Stop& stop : system.stops) *row++ = stop.gap - stop.row.dot(sample.state.q);
  row = std::copy(sample.forces.begin(), sample.forces.end(), row);
  if (sample.energy) {
    const EnergyEntries entries = energy_entries(system, *sample.energy);
    *row++ = sample.energy->now;
    add(entries.forcing);
    add(entries.load);
    add(entries.constraint);
    add(entries.impacts);
    add(entries.dissipation);
    add(entries.contact);
  }
  for (const ProbeRow& probe : probes) *row++ = probe.value(sample.state);
  return row;
}

std::string samples_csv_row(const System& system, const Sample& sample,
                            const std::vector<ProbeRow>& probes) {
  std::vector<double> row(sample_numbers(system, sample, probes));
  write_sample_row(system, sample, probes, row.data());
  std::string text = csv_cell(row.front());
  for (std::size_t i = 1; i < row.size(); ++i)
    fmt::format_to(std::back_inserter(text), ",{}", csv_cell(row[i]));
  return text + "\n";
}

ResultTable section_table(const RunSection& section) {
  const bool of_impacts = section.kind() == DiagramSection::kImpact;
  ResultTable table(of_impacts ? "time,stop,phase,speed" : "time,stop,displacement,velocity");
  for (const SectionPoint& point : section.points())
    table.add(point.time, point.stop + 1, point.across, point.up);
  return table;
}

ResultTable orbits_table(const OrbitRecord& record) {
  ResultTable table(
      "orbit,period,impacts,impact,stop,period_index,phase,speed,stable,admissible,"
      "clearance,largest_multiplier,residual,stuck");
  int number = 0;
  for (const Orbit& orbit : record.found.orbits) {
    ++number;
    int index = 0;
    const double largest =
        orbit.multipliers.empty() ? NAN : std::abs(orbit.multipliers.front().value);
    for (const OrbitImpact& impact : orbit.impacts)
      table.add(number, orbit.period, orbit.impacts.size(), ++index, impact.stop + 1,
                impact.period_index, impact.phase, impact.speed, orbit.stable, orbit.admissible,
                orbit.clearance, largest, orbit.residual, orbit.sticks());
  }
  return table;
}

ResultTable stuck_table(const OrbitRecord& record) {
  ResultTable table(
      "orbit,stop,from_period_index,from_phase,to_period_index,to_phase,duration,force,"
      "smallest_force");
  for (std::size_t i = 0; i < record.found.orbits.size(); ++i)
    for (const StickingPhase& sticking : record.found.orbits[i].sticking)
      table.add(i + 1, sticking.stop + 1, sticking.from.period_index, sticking.from.phase,
                sticking.to.period_index, sticking.to.phase, sticking.duration, sticking.force,
                sticking.smallest_force);
  return table;
}

ResultTable contacts_table(const OrbitRecord& record) {
  ResultTable table("orbit,impact,stop,duration,peak_force,effective_restitution,energy_change");
  for (std::size_t i = 0; i < record.found.orbits.size(); ++i) {
    const Orbit& orbit = record.found.orbits[i];
    for (std::size_t k = 0; k < orbit.impacts.size(); ++k) {
      if (!orbit.impacts[k].contact) continue;
      const OrbitContact& contact = *orbit.impacts[k].contact;
      if (!(contact.duration > 0.0)) continue;
      table.add(i + 1, k + 1, orbit.impacts[k].stop + 1, contact.duration, contact.peak_force,
                contact.speed_after / orbit.impacts[k].speed, -contact.taken);
    }
  }
  return table;
}

ResultTable branches_table(const BranchRecord& record) {
  std::string names =
      "branch,component,period,impacts,value,phase,speed,stable,admissible,"
      "unstable_multipliers,clearance,stuck";
  names += amplitude_columns(record.amplitudes.places);
  ResultTable table(names);
  for (std::size_t i = 0; i < record.traced.branches.size(); ++i) {
    const OrbitBranch& branch = record.traced.branches[i];
    for (std::size_t k = 0; k < branch.points.size(); ++k) {
      const OrbitBranchPoint& point = branch.points[k];
      const Orbit& orbit = point.orbit;
      table.add(branch.id, branch.component, branch.pattern.period, orbit.impacts.size(),
                point.value, first_phase(orbit), first_speed(orbit), orbit.stable, orbit.admissible,
                point.unstable_multipliers, orbit.clearance, branch.sticks());
      add_amplitudes(record.amplitudes.places,
                     record.amplitudes.empty() ? nullptr : &record.amplitudes.branches[i].points[k],
                     table);
    }
  }
  return table;
}

ResultTable special_table(const BranchRecord& record) {
  ResultTable table(
      "id,label,branch,value,phase,speed,multiplier_re,multiplier_im,bracket_from,"
      "bracket_to,converged");
  for (const OrbitBranch& branch : record.traced.branches)
    for (const SpecialPoint& s : branch.special) {
      table.add(s.id, label_of(s.kind), branch.id, s.at.value);
      if (const std::optional<SpecialPoint::Impact> impact = s.impact())
        table.add(impact->phase, impact->speed);
      else
        table.skip(2);
      if (s.multiplier)
        table.add(s.multiplier->real(), s.multiplier->imag());
      else
        table.skip(2);
      if (const std::optional<Bracket>& bracket = s.solution.bracket)
        table.add(bracket->from, bracket->to, bracket->converged);
      else
        table.skip(2).add(std::optional<bool>());
    }
  return table;
}

}  // namespace graze
