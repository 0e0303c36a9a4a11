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
#include "graze/report/csv/detail/csv_cell.hpp"
#include "graze/report/detail/names.hpp"
#include "graze/system/detail/hub_state.hpp"

namespace graze {

std::string csv_cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }
std::string csv_cell(const std::optional<double>& value) { return value ? csv_cell(*value) : ""; }
std::string csv_cell(const std::optional<bool>& value) { return value ? (*value ? "1" : "0") : ""; }

namespace {

// Of the first impact; empty where the orbit has none, at rest on its stop.
std::string first_phase(const Orbit& orbit) {
  return orbit.impacts.empty() ? "" : csv_cell(orbit.impacts.front().phase);
}

std::string first_speed(const Orbit& orbit) {
  return orbit.impacts.empty() ? "" : csv_cell(orbit.impacts.front().speed);
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

std::string section_csv(const RunSection& section) {
  std::string text = section.kind() == DiagramSection::kImpact
                         ? "time,stop,phase,speed\n"
                         : "time,stop,displacement,velocity\n";
  for (const SectionPoint& point : section.points())
    text += fmt::format("{},{},{},{}\n", csv_cell(point.time), point.stop + 1,
                        csv_cell(point.across), csv_cell(point.up));
  return text;
}

std::string orbits_csv(const OrbitRecord& record) {
  std::string text =
      "orbit,period,impacts,impact,stop,period_index,phase,speed,stable,admissible,clearance,"
      "largest_multiplier,residual,stuck\n";
  int number = 0;
  for (const Orbit& orbit : record.found.orbits) {
    ++number;
    int index = 0;
    const double largest =
        orbit.multipliers.empty() ? NAN : std::abs(orbit.multipliers.front().value);
    for (const OrbitImpact& impact : orbit.impacts)
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                     number, orbit.period, orbit.impacts.size(), ++index, impact.stop + 1,
                     impact.period_index, csv_cell(impact.phase), csv_cell(impact.speed),
                     csv_cell(orbit.stable), orbit.admissible ? 1 : 0, csv_cell(orbit.clearance),
                     csv_cell(largest), csv_cell(orbit.residual), orbit.sticks() ? 1 : 0);
  }
  return text;
}

std::string stuck_csv(const OrbitRecord& record) {
  std::string text =
      "orbit,stop,from_period_index,from_phase,to_period_index,to_phase,duration,force,"
      "smallest_force\n";
  for (std::size_t i = 0; i < record.found.orbits.size(); ++i) {
    for (const StickingPhase& sticking : record.found.orbits[i].sticking)
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{}\n", i + 1,
                     sticking.stop + 1, sticking.from.period_index, csv_cell(sticking.from.phase),
                     sticking.to.period_index, csv_cell(sticking.to.phase),
                     csv_cell(sticking.duration), csv_cell(sticking.force),
                     csv_cell(sticking.smallest_force));
  }
  return text;
}

std::string contacts_csv(const OrbitRecord& record) {
  std::string text = "orbit,impact,stop,duration,peak_force,effective_restitution,energy_change\n";
  for (std::size_t i = 0; i < record.found.orbits.size(); ++i) {
    const Orbit& orbit = record.found.orbits[i];
    for (std::size_t k = 0; k < orbit.impacts.size(); ++k) {
      if (!orbit.impacts[k].contact) continue;
      const OrbitContact& contact = *orbit.impacts[k].contact;
      if (!(contact.duration > 0.0)) continue;
      fmt::format_to(
          std::back_inserter(text), "{},{},{},{},{},{},{}\n", i + 1, k + 1,
          orbit.impacts[k].stop + 1, csv_cell(contact.duration), csv_cell(contact.peak_force),
          csv_cell(contact.speed_after / orbit.impacts[k].speed), csv_cell(-contact.taken));
    }
  }
  return text;
}

std::string branches_csv(const BranchRecord& record) {
  std::string text =
      "branch,component,period,impacts,value,phase,speed,stable,admissible,unstable_multipliers,"
      "clearance,stuck";
  text += amplitude_columns(record.amplitudes.places) + "\n";
  for (std::size_t i = 0; i < record.traced.branches.size(); ++i) {
    const OrbitBranch& branch = record.traced.branches[i];
    for (std::size_t k = 0; k < branch.points.size(); ++k) {
      const OrbitBranchPoint& point = branch.points[k];
      const Amplitudes* measured =
          record.amplitudes.empty() ? nullptr : &record.amplitudes.branches[i].points[k];
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{}{}\n", branch.id,
                     branch.component, branch.pattern.period, point.orbit.impacts.size(),
                     csv_cell(point.value), first_phase(point.orbit), first_speed(point.orbit),
                     csv_cell(point.orbit.stable), point.orbit.admissible ? 1 : 0,
                     point.unstable_multipliers, csv_cell(point.orbit.clearance),
                     branch.sticks() ? 1 : 0, amplitude_cells(record.amplitudes.places, measured));
    }
  }
  return text;
}

std::string special_csv(const BranchRecord& record) {
  std::string text =
      "id,label,branch,value,phase,speed,multiplier_re,multiplier_im,bracket_from,bracket_to,"
      "converged\n";
  for (const OrbitBranch& branch : record.traced.branches)
    for (const SpecialPoint& s : branch.special) {
      const std::optional<SpecialPoint::Impact> impact = s.impact();
      const std::optional<Bracket>& bracket = s.solution.bracket;
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{}\n", s.id,
                     label_of(s.kind), branch.id, csv_cell(s.at.value),
                     impact ? csv_cell(impact->phase) : "", impact ? csv_cell(impact->speed) : "",
                     s.multiplier ? csv_cell(s.multiplier->real()) : "",
                     s.multiplier ? csv_cell(s.multiplier->imag()) : "",
                     bracket ? csv_cell(bracket->from) : "", bracket ? csv_cell(bracket->to) : "",
                     bracket ? (bracket->converged ? "1" : "0") : "");
    }
  return text;
}

}  // namespace graze
