#include <fmt/format.h>

#include "graze/record/names/motion_names.hpp"
#include "graze/record/records.hpp"
#include "graze/report/text/detail/number_text.hpp"
#include "graze/report/text/detail/sentences.hpp"
#include "graze/report/text/detail/table.hpp"
#include "graze/report/text/detail/text_amplitudes.hpp"
#include "graze/report/text/detail/text_statistics.hpp"
#include "graze/report/text/detail/text_units.hpp"
#include "graze/report/text/text.hpp"

namespace graze {
namespace {

std::vector<std::string> event_row(long long number, const Event& e) {
  const bool impact = e.kind == EventKind::kImpact, chatter = e.kind == EventKind::kChatter;
  const bool contact = e.kind == EventKind::kContact, parting = e.kind == EventKind::kSeparation;
  std::string force = "-";
  if (e.kind == EventKind::kStick || e.kind == EventKind::kFrictionStick)
    force = digits_text(e.force, 6);
  if (parting) force = digits_text(e.peak_force, 6);
  return {fmt::format("{}", number),
          name_of(e.kind),
          digits_text(e.time, 12),
          e.stop < 0 ? fmt::format("friction {}", e.friction + 1) : fmt::format("{}", e.stop + 1),
          impact || contact || parting ? digits_text(e.speed, 9) : "-",
          (impact || contact) && e.phase ? decimals_text(*e.phase, 9) : "-",
          impact || chatter || parting ? power_text(e.energy_change, 4) : "-",
          chatter ? fmt::format("{}", e.impacts) : "-",
          force};
}

std::string events_text(const SimulationRecord& record, const TextOptions& options) {
  const EventExcerpt& events = record.excerpt;
  if (events.count() == 0) return "";
  const TextUnits in(record.info.units);
  Table table({"event", "kind", in.head("time", "s"), "stop", in.head("speed", "m/s"),
               in.head("phase", "rad"), in.head("energy change", "J"), "impacts",
               in.head("force", "N")});
  long long number = 0;
  for (const Event& event : events.first()) table.add(event_row(++number, event));
  if (events.left_out() > 0) table.add({".."});
  number += events.left_out();
  for (const Event& event : events.last()) table.add(event_row(++number, event));
  return table.text(options.width) + "\n";
}

std::string energy_text(const System& system, const EnergyBalance& balance,
                        const std::string& unit) {
  const EnergyEntries entries = energy_entries(system, balance);
  const std::string in = unit.empty() ? "" : " " + unit;
  std::string text;
  const auto add = [&](const char* name, const std::optional<double>& value) {
    if (value) text += fmt::format("{:<24} {:>15}{}\n", name, digits_text(*value, 8), in);
  };
  add("energy at the start", balance.start);
  const bool turns = system.turns();
  add(turns ? "+ work of the torque" : "+ work of the forcing", entries.forcing);
  add(turns ? "+ work of the weight" : "+ work of the load", entries.load);
  add("+ work of closed stops", entries.constraint);
  add("+ work of moving stops", entries.stops);
  add("+ change at impacts", entries.impacts);
  add("+ work of compliant stops", entries.contact);
  add("+ work of dry friction", entries.friction);
  add("- dissipation", entries.dissipation);
  add("= energy at the end", balance.now);
  return text + fmt::format("{:<24} {:>15}{}, {} of the largest entry\n", "error of the balance",
                            power_text(balance.defect(), 2), in,
                            power_text(relative_defect(balance), 1));
}

std::string totals_text(const SimulationRecord& record) {
  const Simulation& run = record.run;
  std::string text;
  const auto add = [&](const char* name, const std::string& value) {
    text += fmt::format("{:<24} {}\n", name, value);
  };
  const TextUnits in(record.info.units);
  add("simulated until", in.quantity(run.end_time, 9, "s"));
  if (!record.system.stops.empty()) {
    add("impacts", std::to_string(run.totals.impacts));
    add("complete chatters", std::to_string(run.totals.chatters));
    add("stuck time", in.quantity(run.totals.stuck_time, 6, "s"));
    add("energy lost at impacts", in.quantity(run.totals.energy_lost, 6, "J"));
    add("energy added at impacts", in.quantity(run.totals.energy_added, 6, "J"));
  }
  if (!record.system.frictions.empty()) {
    add("slips", std::to_string(run.totals.slips));
    add("reversals", std::to_string(run.totals.reversals));
    add(record.system.frictions.size() == 1 ? "sticking time" : "time all friction sticks",
        in.quantity(run.totals.sticking_time, 6, "s"));
  }
  if (run.totals.smallest_gap) add("smallest gap", in.quantity(*run.totals.smallest_gap, 6, "m"));
  for (const int stop : run.stuck)
    add("at rest at the end on",
        fmt::format("stop {}, force {}", stop + 1,
                    in.quantity(run.forces[static_cast<std::size_t>(stop)], 6, "N")));
  if (record.section)
    add("section", fmt::format("{} points from {} on", record.section->points().size(),
                               in.quantity(record.section->from(), 6, "s")));
  return text;
}

}  // namespace

std::string to_text(const SimulationRecord& record, const TextOptions& options) {
  const Simulation& run = record.run;
  const TextUnits in(record.info.units);
  std::string text = events_text(record, options) + totals_text(record);
  if (run.amplitudes)
    text += fmt::format("\nmeasured over {}\n", in.quantity(run.amplitudes->duration, 9, "s")) +
            amplitudes_text(record.places, *run.amplitudes, record.info.units, options);
  if (record.statistics) text += statistics_text(record, options) + "\n";
  if (run.energy) text += "\n" + energy_text(record.system, *run.energy, in("J"));
  return text + notes_text(record.notes, {}, options) + ending(record.outcome);
}

}  // namespace graze
