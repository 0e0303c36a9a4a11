#include <fmt/format.h>

#include <algorithm>

#include "graze/assembly/probes.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/text/detail/sentences.hpp"
#include "graze/report/text/detail/text_units.hpp"
#include "graze/report/text/text.hpp"

namespace graze {
namespace {

// "0.12" or "0.12 .. 0.34".
std::string range_text(double low, double high) {
  if (low == high) return digits_text(low, 6);
  return fmt::format("{} .. {}", digits_text(low, 6), digits_text(high, 6));
}

bool is_alike(const ValueRun& a, const ValueRun& b) {
  return a.impacts.size() == b.impacts.size() && a.outcome == b.outcome;
}

// The row of the runs from `first` to `last`, which are alike.
std::vector<std::string> range_row(const RunDiagramRecord& record, std::size_t first,
                                   std::size_t last) {
  const std::vector<ValueRun>& runs = record.runs;
  const std::size_t impacts = runs[first].impacts.size();
  std::vector<std::string> row = {
      digits_text(runs[first].value, 8), digits_text(runs[last].value, 8),
      std::to_string(last - first + 1),
      std::to_string(impacts) + (runs[first].outcome == RunOutcome::kReachedEnd ? "" : ", cut")};
  const auto range = [&](auto part) {
    double low = part(runs[first]), high = low;
    for (std::size_t k = first; k <= last; ++k) {
      low = std::min(low, part(runs[k]));
      high = std::max(high, part(runs[k]));
    }
    return range_text(low, high);
  };
  if (record.stops > 0) {
    row.push_back(impacts == 0 ? "-"
                               : range([](const ValueRun& run) { return run.impacts[0].time; }));
    row.push_back(impacts == 0 ? "-"
                               : range([](const ValueRun& run) { return run.impacts[0].speed; }));
  }
  for (std::size_t i = 0; i < record.probes.size(); ++i)
    row.push_back(range([i](const ValueRun& run) { return run.peaks[i]; }));
  return row;
}

}  // namespace

std::string to_text(const RunDiagramRecord& record, const TextOptions& options) {
  const TextUnits in(record.info.units);
  std::vector<std::string> header = {with_unit("from", record.unit), with_unit("to", record.unit),
                                     "values", "impacts"};
  if (record.stops > 0) {
    header.push_back(in.head("first", "s"));
    header.push_back(in.head("its speed", "m/s"));
  }
  for (std::size_t i = 0; i < record.probes.size(); ++i)
    header.push_back(in.head(fmt::format("peak {}", i + 1), probe_unit(record.probes[i].quantity)));
  Table table(header, {2, {}});
  std::size_t impacts = 0;
  for (std::size_t first = 0, last = 0; first < record.runs.size(); first = last + 1) {
    last = first;
    while (last + 1 < record.runs.size() && is_alike(record.runs[first], record.runs[last + 1]))
      ++last;
    table.add(range_row(record, first, last));
    impacts += (last - first + 1) * record.runs[first].impacts.size();
  }
  std::string text = fmt::format("runs of {} over {}, each from the scene's initial state\n",
                                 in.quantity(record.duration, 6, "s"), record.parameter);
  if (!table.empty()) text += table.text(options.width) + "\n";
  text += fmt::format("{} values, {} impacts\n", record.runs.size(), impacts);
  return text + ending(record.outcome);
}

}  // namespace graze
