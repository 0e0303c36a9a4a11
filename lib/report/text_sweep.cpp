#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/report/sweep_names.hpp"
#include "graze/report/table.hpp"
#include "graze/report/text.hpp"

namespace graze {
namespace {

// What "settled" does not say of some rows.
std::string approaching_note(const Sweep& swept) {
  std::size_t count = 0;
  double farthest = 0.0;
  for (const SweepRow& row : swept.rows) {
    if (row.status != SweepStatus::kApproaching) continue;
    ++count;
    if (std::isfinite(row.motion.remaining)) farthest = std::max(farthest, row.motion.remaining);
  }
  if (count == 0) return "";
  return fmt::format(
      "note: at {} value{} the motion repeats but is not known to be within {:g} of its orbit "
      "after "
      "{} periods{}; more --periods bring it nearer or show that it goes elsewhere\n",
      count, count == 1 ? "" : "s", swept.options.nearness, swept.options.periods,
      farthest > 0.0 ? fmt::format(" (up to {:.1g} away)", farthest) : "");
}

}  // namespace

std::string to_text(const DiagramRecord& record) {
  const Sweep& swept = record.swept;
  const std::string unit =
      record.branches.unit.empty() ? "" : fmt::format(" ({})", record.branches.unit);
  Table ranges({"from" + unit, "to" + unit, "values", "settles on"});
  for (const AttractorRange& range : attractor_ranges(swept.rows))
    ranges.add({fmt::format("{:.8g}", swept.rows[range.first].value),
                fmt::format("{:.8g}", swept.rows[range.last].value),
                fmt::format("{}", range.last - range.first + 1), attractor_label(range.attractor)});
  std::string text = fmt::format("sweep over {}, {}\n", swept.parameter,
                                 swept.options.direction == SweepDirection::kFresh
                                     ? "each value from the scene's initial state"
                                     : name_of(swept.options.direction));
  if (!ranges.empty()) text += ranges.text() + "\n";
  text += fmt::format("{} values, {} forcing periods, {} impacts\n", swept.rows.size(),
                      swept.periods, swept.impacts);
  text += approaching_note(swept);
  if (record.branches.traced.branches.empty()) {
    for (const std::string& note : record.branches.traced.notes) text += "note: " + note + "\n";
    const Outcome& outcome = record.branches.outcome;
    if (!outcome.message.empty()) text += fmt::format("{}: {}\n", outcome.name, outcome.message);
    return text;
  }
  return text + "\n" + to_text(record.branches);
}

}  // namespace graze
