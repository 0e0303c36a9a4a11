#include <fmt/format.h>

#include <algorithm>

#include "graze/record/names/motion_names.hpp"
#include "graze/record/records.hpp"
#include "graze/report/text/detail/number_text.hpp"
#include "graze/report/text/detail/sentences.hpp"
#include "graze/report/text/detail/table.hpp"
#include "graze/report/text/detail/text_units.hpp"
#include "graze/report/text/text.hpp"

namespace graze {
namespace {

// For an orbit that closes a chatter only the first and the last impacts are shown.
constexpr std::size_t kShownImpacts = 8;

// The properties in which the orbits of a record differ; common ones are not repeated.
struct Shows {
  bool stop = false, period = false, admissible = false, lasts = false;

  explicit Shows(const OrbitRecord& record) : stop(record.system.stops.size() > 1) {
    for (const Orbit& orbit : record.found.orbits) {
      period = period || orbit.period > 1;
      admissible = admissible || !orbit.admissible;
      lasts = lasts || orbit.lasts;
    }
  }
};

// Properties of the orbit as a whole.
std::vector<std::string> whole_of(const Orbit& orbit, const Shows& shows,
                                  const TextOptions& options) {
  std::vector<std::string> cells = {stability_word(orbit.stable)};
  if (shows.admissible) cells.emplace_back(orbit.admissible ? "yes" : "no");
  if (shows.lasts) cells.push_back(digits_text(orbit.lasts, 12));
  cells.push_back(digits_text(orbit.clearance, 4));
  cells.push_back(orbit.multipliers.empty() ? "-"
                                            : complex_text(orbit.multipliers.front().known(), 6));
  if (options.verbose) cells.push_back(power_text(orbit.residual, 1));
  return cells;
}

std::string orbits_text(const OrbitRecord& record, const TextOptions& options) {
  const Shows shows(record);
  const TextUnits in(record.info.units);
  std::vector<std::string> header = {"orbit", "(p, k)"};
  if (shows.stop) header.emplace_back("stop");
  if (shows.period) header.emplace_back("period");
  header.insert(header.end(), {in.head("phase", "rad"), in.head("speed", "m/s")});
  const std::size_t of_impacts = header.size();
  header.emplace_back("stable");
  if (shows.admissible) header.emplace_back("admissible");
  if (shows.lasts) header.push_back(in.head("lasts", "s"));
  header.insert(header.end(), {in.head("clearance", "m"), "largest multiplier"});
  if (options.verbose) header.emplace_back("residual");
  Table table(header, {2, {of_impacts}});
  int number = 0;
  for (const Orbit& orbit : record.found.orbits) {
    ++number;
    const std::size_t count = orbit.impacts.size();
    if (count == 0 && !orbit.sticks()) {
      std::vector<std::string> row{std::to_string(number), fmt::format("({}, 0)", orbit.period)};
      row.resize(of_impacts, "-");
      for (std::string& cell : whole_of(orbit, shows, options)) row.push_back(std::move(cell));
      table.add(row);
    }
    const bool excerpt = orbit.sticks() && count > 2 * kShownImpacts;
    for (std::size_t i = 0; i < count; ++i) {
      if (excerpt && i == kShownImpacts) {
        table.add({"", ".."});
        i = count - kShownImpacts;
      }
      const OrbitImpact& impact = orbit.impacts[i];
      std::vector<std::string> row{"", ""};
      if (shows.stop) row.push_back(std::to_string(impact.stop + 1));
      if (shows.period) row.push_back(std::to_string(impact.period_index));
      row.push_back(decimals_text(impact.phase, 12));
      row.push_back(digits_text(impact.speed, 12));
      if (i == 0) {
        row[0] = std::to_string(number);
        row[1] = fmt::format("({}, {})", orbit.period, count);
        for (std::string& cell : whole_of(orbit, shows, options)) row.push_back(std::move(cell));
      }
      table.add(row);
    }
  }
  return table.empty() ? "" : table.text(options.width) + "\n";
}

std::string sticking_text(const OrbitRecord& record, const TextOptions& options) {
  const std::vector<Orbit>& orbits = record.found.orbits;
  const TextUnits in(record.info.units);
  Table table({"orbit", "stuck on stop", in.head("from phase", "rad"), in.head("to phase", "rad"),
               in.head("duration", "s"), in.head("force", "N"), in.head("smallest force", "N")});
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    const auto at = [&](const OrbitInstant& instant) {
      const std::string phase = decimals_text(instant.phase, 12);
      return orbits[i].period == 1 ? phase
                                   : fmt::format("{}, period {}", phase, instant.period_index);
    };
    for (const StickingPhase& sticking : orbits[i].sticking)
      table.add({fmt::format("{}", i + 1), fmt::format("{}", sticking.stop + 1), at(sticking.from),
                 at(sticking.to), digits_text(sticking.duration, 9), digits_text(sticking.force, 6),
                 digits_text(sticking.smallest_force, 6)});
  }
  return table.empty() ? "" : table.text(options.width) + "\n";
}

std::string rubbing_text(const OrbitRecord& record, const TextOptions& options) {
  const TextUnits in(record.info.units);
  Table table({"orbit", "friction", "from then on", in.head("phase", "rad")});
  int number = 0;
  for (const Orbit& orbit : record.found.orbits) {
    ++number;
    for (const OrbitRubbing& event : orbit.rubbing)
      table.add({fmt::format("{}", number), fmt::format("{}", event.friction + 1),
                 event.what == Rubs::kSticks    ? "sticks"
                 : event.what == Rubs::kForward ? "slides forward"
                                                : "slides backward",
                 decimals_text(event.at.phase, 12) +
                     (orbit.period == 1 ? "" : fmt::format(", period {}", event.at.period_index))});
  }
  return table.empty() ? "" : table.text(options.width) + "\n";
}

// Contacts at compliant stops.
std::string contacts_text(const OrbitRecord& record, const TextOptions& options) {
  const std::vector<Orbit>& orbits = record.found.orbits;
  const TextUnits in(record.info.units);
  Table table({"orbit", "impact", "stop", in.head("duration", "s"), in.head("peak force", "N"),
               "effective restitution", in.head("energy change", "J")},
              {2, {}});
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    for (std::size_t k = 0; k < orbits[i].impacts.size(); ++k) {
      const OrbitImpact& impact = orbits[i].impacts[k];
      if (!impact.contact || !(impact.contact->duration > 0.0)) continue;
      const OrbitContact& contact = *impact.contact;
      table.add({fmt::format("{}", i + 1), fmt::format("{}", k + 1),
                 fmt::format("{}", impact.stop + 1), digits_text(contact.duration, 9),
                 digits_text(contact.peak_force, 6),
                 impact.speed > 0.0 ? digits_text(contact.speed_after / impact.speed, 6) : "-",
                 power_text(-contact.taken, 4)});
    }
  }
  return table.empty() ? "" : table.text(options.width) + "\n";
}

}  // namespace

std::string to_text(const OrbitRecord& record, const TextOptions& options) {
  return orbits_text(record, options) + sticking_text(record, options) +
         rubbing_text(record, options) + contacts_text(record, options) +
         notes_text(record.found.notes, record.found.details, options) + ending(record.outcome);
}

}  // namespace graze
