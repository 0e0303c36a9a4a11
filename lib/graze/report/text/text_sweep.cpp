#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/report/names/detail/sweep_names.hpp"
#include "graze/report/text/detail/table.hpp"
#include "graze/report/text/text.hpp"

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

// The largest exponents of neighbouring rows, 1/s: "-0.12 .. -0.03", "-inf".
std::string largest_exponents(const Sweep& swept, const AttractorRange& range) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool any = false;
  for (std::size_t i = range.first; i <= range.last; ++i) {
    const std::optional<Exponents>& exponents = swept.rows[i].exponents;
    if (!exponents || exponents->values.size() == 0 || std::isnan(exponents->values[0])) continue;
    any = true;
    low = std::min(low, exponents->values[0]);
    high = std::max(high, exponents->values[0]);
  }
  if (!any) return "-";
  return low == high ? fmt::format("{:.4g}", low) : fmt::format("{:.4g} .. {:.4g}", low, high);
}

}  // namespace

std::string to_text(const DiagramRecord& record) {
  const Sweep& swept = record.swept;
  const std::string unit =
      record.branches.unit.empty() ? "" : fmt::format(" ({})", record.branches.unit);
  std::vector<std::string> header = {"from" + unit, "to" + unit, "values", "settles on"};
  const bool has_exponents = swept.options.exponent_periods > 0;
  if (has_exponents) header.emplace_back("largest exponent (1/s)");
  Table ranges(header);
  for (const AttractorRange& range : attractor_ranges(swept.rows)) {
    std::vector<std::string> row = {fmt::format("{:.8g}", swept.rows[range.first].value),
                                    fmt::format("{:.8g}", swept.rows[range.last].value),
                                    fmt::format("{}", range.last - range.first + 1),
                                    attractor_label(range.attractor)};
    if (has_exponents) row.push_back(largest_exponents(swept, range));
    ranges.add(row);
  }
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
