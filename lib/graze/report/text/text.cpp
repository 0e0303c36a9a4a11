#include "graze/report/text/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/record/records.hpp"
#include "graze/report/detail/names.hpp"
#include "graze/report/text/detail/table.hpp"
#include "graze/report/text/detail/text_amplitudes.hpp"

namespace graze {
namespace {

std::string complex_text(const Complex& z) {
  if (z.imag() == 0.0) return fmt::format("{:.7g}", z.real());
  return fmt::format("{:.7g} {} {:.7g}i", z.real(), z.imag() < 0 ? "-" : "+", std::abs(z.imag()));
}

std::string ending(const Outcome& outcome) {
  return outcome.message.empty() ? "" : fmt::format("{}: {}\n", outcome.name, outcome.message);
}

std::string notes_text(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += fmt::format("note: {}\n", note);
  return text;
}

std::vector<std::string> event_row(long long number, const Event& e) {
  const bool impact = e.kind == EventKind::kImpact, chatter = e.kind == EventKind::kChatter;
  const bool contact = e.kind == EventKind::kContact, parting = e.kind == EventKind::kSeparation;
  std::string force = "-";
  if (e.kind == EventKind::kStick) force = fmt::format("{:.6g}", e.force);
  if (parting) force = fmt::format("{:.6g}", e.peak_force);
  return {fmt::format("{}", number),
          name_of(e.kind),
          fmt::format("{:.12g}", e.time),
          fmt::format("{}", e.stop + 1),
          impact || contact || parting ? fmt::format("{:.9g}", e.speed) : "-",
          (impact || contact) && e.phase ? fmt::format("{:.9f}", *e.phase) : "-",
          impact || chatter || parting ? fmt::format("{:.4e}", e.energy_change) : "-",
          chatter ? fmt::format("{}", e.impacts) : "-",
          force};
}

std::string events_text(const EventExcerpt& events) {
  if (events.count() == 0) return "";
  Table table({"event", "kind", "time (s)", "stop", "speed (m/s)", "phase (rad)",
               "energy change (J)", "impacts", "force (N)"});
  long long number = 0;
  for (const Event& event : events.first()) table.add(event_row(++number, event));
  if (events.left_out() > 0) table.add({".."});
  number += events.left_out();
  for (const Event& event : events.last()) table.add(event_row(++number, event));
  return table.text() + "\n";
}

std::string energy_text(const System& system, const EnergyBalance& balance) {
  const EnergyEntries entries = energy_entries(system, balance);
  std::string text;
  const auto add = [&](const char* name, const std::optional<double>& value) {
    if (value) text += fmt::format("{:<24} {:>15.8g} J\n", name, *value);
  };
  add("energy at the start", balance.start);
  const bool turns = system.turns();
  add(turns ? "+ work of the torque" : "+ work of the forcing", entries.forcing);
  add(turns ? "+ work of the weight" : "+ work of the load", entries.load);
  add("+ work of closed stops", entries.constraint);
  add("+ change at impacts", entries.impacts);
  add("+ work of compliant stops", entries.contact);
  add("- dissipation", entries.dissipation);
  add("= energy at the end", balance.now);
  return text + fmt::format("{:<24} {:>15.2e} J, {:.1e} of the largest entry\n", "missing",
                            balance.defect(), relative_defect(balance));
}

// Of the impacts of an orbit that closes a chatter only the first and the last are shown.
constexpr std::size_t kShownImpacts = 8;

std::string sticking_text(const std::vector<Orbit>& orbits) {
  Table table({"orbit", "stuck on stop", "from phase (rad)", "to phase (rad)", "duration (s)",
               "force (N)", "smallest force (N)"});
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    const auto at = [&](const OrbitInstant& instant) {
      return orbits[i].period == 1
                 ? fmt::format("{:.12f}", instant.phase)
                 : fmt::format("{:.12f}, period {}", instant.phase, instant.period_index);
    };
    for (const StickingPhase& sticking : orbits[i].sticking)
      table.add({fmt::format("{}", i + 1), fmt::format("{}", sticking.stop + 1), at(sticking.from),
                 at(sticking.to), fmt::format("{:.9g}", sticking.duration),
                 fmt::format("{:.6g}", sticking.force),
                 sticking.smallest_force ? fmt::format("{:.6g}", *sticking.smallest_force) : "-"});
  }
  return table.empty() ? "" : table.text() + "\n";
}

// Contacts at compliant stops.
std::string contacts_text(const std::vector<Orbit>& orbits) {
  Table table({"orbit", "impact", "stop", "duration (s)", "peak force (N)", "effective restitution",
               "energy change (J)"});
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    for (std::size_t k = 0; k < orbits[i].impacts.size(); ++k) {
      if (!orbits[i].impacts[k].contact) continue;
      const OrbitContact& contact = *orbits[i].impacts[k].contact;
      if (!(contact.duration > 0.0)) continue;
      table.add({fmt::format("{}", i + 1), fmt::format("{}", k + 1),
                 fmt::format("{}", orbits[i].impacts[k].stop + 1),
                 fmt::format("{:.9g}", contact.duration), fmt::format("{:.6g}", contact.peak_force),
                 orbits[i].impacts[k].speed > 0.0
                     ? fmt::format("{:.6g}", contact.speed_after / orbits[i].impacts[k].speed)
                     : "-",
                 fmt::format("{:.4e}", -contact.taken)});
    }
  }
  return table.empty() ? "" : table.text() + "\n";
}

// Special points that nothing more than a bracket is known of.
std::string bracketed_only(const std::vector<OrbitBranch>& branches) {
  std::string text;
  for (const OrbitBranch& branch : branches)
    for (const SpecialPoint& s : branch.special)
      if (s.solution.bracket && !s.solution.bracket->converged)
        text += fmt::format("{} was not solved for: it lies between {:.9g} and {:.9g}\n", s.id,
                            s.solution.bracket->from, s.solution.bracket->to);
  return text;
}

}  // namespace

std::string to_text(const SimulationRecord& record) {
  const Simulation& run = record.run;
  std::string text = events_text(record.excerpt);
  text += fmt::format("{:<24} {:.9g} s\n", "simulated until", run.end_time);
  if (!record.system.stops.empty()) {
    text += fmt::format("{:<24} {}\n", "impacts", run.totals.impacts);
    text += fmt::format("{:<24} {}\n", "chatters summed", run.totals.chatters);
    text += fmt::format("{:<24} {:.6g} s\n", "stuck time", run.totals.stuck_time);
    text += fmt::format("{:<24} {:.6g} J\n", "energy lost at impacts", run.totals.energy_lost);
    text += fmt::format("{:<24} {:.6g} J\n", "energy added at impacts", run.totals.energy_added);
  }
  if (run.totals.smallest_gap)
    text += fmt::format("{:<24} {:.6g} m\n", "smallest gap", *run.totals.smallest_gap);
  for (const int stop : run.stuck)
    text += fmt::format("{:<24} stop {}, force {:.6g} N\n", "held at the end by", stop + 1,
                        run.forces[static_cast<std::size_t>(stop)]);
  if (record.section)
    text += fmt::format("{:<24} {} points from {:.6g} s on\n", "section",
                        record.section->points().size(), record.section->from());
  if (run.amplitudes)
    text += fmt::format("\nmeasured over {:.9g} s\n", run.amplitudes->duration) +
            amplitudes_text(record.places, *run.amplitudes);
  if (run.energy) text += "\n" + energy_text(record.system, *run.energy);
  return text + notes_text(record.notes) + ending(record.outcome);
}

std::string to_text(const OrbitRecord& record) {
  std::string text;
  Table table({"orbit", "(p, k)", "phase (rad)", "speed (m/s)", "stable", "admissible",
               "clearance (m)", "largest multiplier", "residual"});
  int number = 0;
  for (const Orbit& orbit : record.found.orbits) {
    bool first = true;
    ++number;
    const std::size_t count = orbit.impacts.size();
    const bool excerpt = orbit.sticks() && count > 2 * kShownImpacts;
    for (std::size_t i = 0; i < count; ++i) {
      if (excerpt && i == kShownImpacts) {
        table.add({"", ".."});
        i = count - kShownImpacts;
      }
      const OrbitImpact& impact = orbit.impacts[i];
      std::vector<std::string> row{"", "", fmt::format("{:.12f}", impact.phase),
                                   fmt::format("{:.12g}", impact.speed)};
      if (first) {
        row[0] = fmt::format("{}", number);
        row[1] = fmt::format("({}, {})", orbit.period, orbit.impacts.size());
        row.push_back(stability_word(orbit.stable));
        row.push_back(orbit.admissible ? "yes" : "no");
        row.push_back(orbit.clearance ? fmt::format("{:.4g}", *orbit.clearance) : "-");
        row.push_back(orbit.multipliers.empty() ? "-"
                                                : complex_text(orbit.multipliers.front().known()));
        row.push_back(fmt::format("{:.1e}", orbit.residual));
      }
      table.add(row);
      first = false;
    }
  }
  if (!table.empty()) text += table.text() + "\n";
  text += sticking_text(record.found.orbits);
  text += contacts_text(record.found.orbits);
  return text + notes_text(record.found.notes) + ending(record.outcome);
}

std::string to_text(const BranchRecord& record) {
  const std::string unit = record.unit.empty() ? "" : fmt::format(" ({})", record.unit);
  const bool switched =
      std::any_of(record.traced.branches.begin(), record.traced.branches.end(),
                  [](const OrbitBranch& branch) { return !branch.origin.empty(); });
  std::vector<std::string> columns = {"branch", "component",     "orbit",          "points",
                                      "stable", "lowest" + unit, "highest" + unit, "ends"};
  if (switched) columns.push_back("from");
  Table branches(columns);
  Table special({"point", "branch", record.traced.parameter + unit, "phase (rad)", "speed (m/s)",
                 "multiplier"});
  for (const OrbitBranch& branch : record.traced.branches) {
    std::size_t stable = 0;
    double lowest = branch.points.front().value, highest = lowest;
    for (const OrbitBranchPoint& point : branch.points) {
      if (point.orbit.stable.value_or(false)) ++stable;
      lowest = std::min(lowest, point.value);
      highest = std::max(highest, point.value);
    }
    const auto end = [](OrbitBranchEnd kind, const OrbitBranchPoint& point) {
      return kind == OrbitBranchEnd::kClosed
                 ? name_of(kind)
                 : fmt::format("{} at {:.8g}", name_of(kind), point.value);
    };
    const std::string ends = branch.ends[0] == OrbitBranchEnd::kClosed
                                 ? name_of(branch.ends[0])
                                 : end(branch.ends[0], branch.points.front()) + ", " +
                                       end(branch.ends[1], branch.points.back());
    std::vector<std::string> row = {
        fmt::format("{}", branch.id),
        fmt::format("{}", branch.component),
        branch.sticks() ? fmt::format("({}, stick)", branch.pattern.period)
                        : fmt::format("({}, {})", branch.pattern.period, branch.pattern.impacts()),
        fmt::format("{}", branch.points.size()),
        fmt::format("{}", stable),
        fmt::format("{:.8g}", lowest),
        fmt::format("{:.8g}", highest),
        ends};
    if (switched) row.push_back(branch.origin.empty() ? "-" : branch.origin);
    branches.add(row);
    for (const SpecialPoint& s : branch.special) {
      const std::optional<SpecialPoint::Impact> impact = s.impact();
      special.add({s.id, fmt::format("{}", branch.id), fmt::format("{:.13g}", s.at.value),
                   impact ? fmt::format("{:.9f}", impact->phase) : "-",
                   impact ? fmt::format("{:.9g}", impact->speed) : "-",
                   s.multiplier ? complex_text(*s.multiplier) : "-"});
    }
  }
  std::string text;
  if (!branches.empty()) text += branches.text() + "\n";
  if (!special.empty()) text += special.text() + "\n";
  text += bracketed_only(record.traced.branches);
  text += fmt::format("{} start{}, ", record.traced.starts, record.traced.starts == 1 ? "" : "s");
  text += record.traced.traced == 0 ? "none traced\n"
                                    : fmt::format("{} evaluations of the shooting equations\n",
                                                  record.traced.shooting_evaluations);
  if (record.traced.switched > 0 || record.traced.left_open > 0)
    text += fmt::format("{} special point{} switched at; {} beyond the depth left open\n",
                        record.traced.switched, record.traced.switched == 1 ? "" : "s",
                        record.traced.left_open);
  return text + notes_text(record.traced.notes) + ending(record.outcome);
}

}  // namespace graze
