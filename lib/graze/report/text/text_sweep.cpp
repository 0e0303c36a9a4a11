#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "graze/record/names/motion_names.hpp"
#include "graze/report/text/detail/folding.hpp"
#include "graze/report/text/detail/sentences.hpp"
#include "graze/report/text/detail/text_units.hpp"
#include "graze/report/text/text.hpp"

namespace graze {
namespace {

// A note on rows that have not come as near to their orbit as requested.
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
      "after {} periods{}; more --periods decide whether it settles there\n",
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
  return low == high ? digits_text(low, 4)
                     : fmt::format("{} .. {}", digits_text(low, 4), digits_text(high, 4));
}

// The ranges of values with one attractor, row by row; attractors at few of all values are folded.
std::string ranges_text(const DiagramRecord& record, const TextOptions& options) {
  const Sweep& swept = record.swept;
  const TextUnits in(record.branches.info.units);
  std::vector<std::string> header = {with_unit("from", record.branches.unit),
                                     with_unit("to", record.branches.unit), "values", "settles on"};
  const bool has_exponents = swept.options.exponent_periods > 0;
  if (has_exponents) header.push_back(in.head("largest exponent", "1/s"));
  Table table(header);
  const std::vector<AttractorRange> ranges = attractor_ranges(swept.rows);
  std::map<std::string, std::size_t> values;  // by what the motion settles on
  for (const AttractorRange& range : ranges)
    values[attractor_title(range.attractor)] += range.last - range.first + 1;
  std::vector<std::size_t> sizes;
  for (const auto& [label, count] : values) sizes.push_back(count);
  const std::size_t all = swept.rows.size();
  const std::vector<bool> is_folded = folded_groups(sizes, all);
  Folded folded;
  for (std::size_t i = 0; const auto& [label, count] : values)
    if (is_folded[i++]) folded.add(count);
  for (const AttractorRange& range : ranges) {
    const std::string label = attractor_title(range.attractor);
    if (is_folded[static_cast<std::size_t>(std::distance(values.begin(), values.find(label)))])
      continue;
    std::vector<std::string> row = {digits_text(swept.rows[range.first].value, 8),
                                    digits_text(swept.rows[range.last].value, 8),
                                    fmt::format("{}", range.last - range.first + 1), label};
    if (has_exponents) row.push_back(largest_exponents(swept, range));
    table.add(row);
  }
  return table.empty() ? "" : table.text(options.width) + folded.text(all) + "\n";
}

}  // namespace

std::string to_text(const DiagramRecord& record, const TextOptions& options) {
  const Sweep& swept = record.swept;
  std::string text = fmt::format("sweep over {}, {}\n", swept.parameter,
                                 swept.options.direction == SweepDirection::kFresh
                                     ? "each value from the scene's initial state"
                                     : name_of(swept.options.direction));
  text += ranges_text(record, options);
  text += fmt::format("{} values, {} forcing periods, {} impacts\n", swept.rows.size(),
                      swept.periods, swept.impacts);
  text += approaching_note(swept);
  if (record.branches.traced.branches.empty()) {
    const OrbitBranches& traced = record.branches.traced;
    return text + notes_text(traced.notes, traced.details, options) +
           ending(record.branches.outcome);
  }
  return text + "\n" + to_text(record.branches, options);
}

}  // namespace graze
