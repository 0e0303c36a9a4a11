#include <fmt/format.h>

#include <algorithm>

#include "graze/assembly/probes.hpp"
#include "graze/record/detail/run_diagram_record.hpp"
#include "graze/report/text/detail/table.hpp"
#include "graze/report/text/text.hpp"

namespace graze {
namespace {

// "0.12" or "0.12 .. 0.34".
std::string range_text(double low, double high) {
  if (low == high) return fmt::format("{:.6g}", low);
  return fmt::format("{:.6g} .. {:.6g}", low, high);
}

bool is_alike(const ValueRun& a, const ValueRun& b) {
  return a.impacts.size() == b.impacts.size() && a.outcome == b.outcome;
}

// What the runs from `first` to `last`, alike, have in common.
std::vector<std::string> range_row(const RunDiagramRecord& record, std::size_t first,
                                   std::size_t last) {
  const std::vector<ValueRun>& runs = record.runs;
  const std::size_t impacts = runs[first].impacts.size();
  std::vector<std::string> row = {
      fmt::format("{:.8g}", runs[first].value), fmt::format("{:.8g}", runs[last].value),
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

std::string to_text(const RunDiagramRecord& record) {
  std::vector<std::string> header = {with_unit("from", record.unit), with_unit("to", record.unit),
                                     "values", "impacts"};
  if (record.stops > 0) {
    header.emplace_back("first (s)");
    header.emplace_back("its speed (m/s)");
  }
  for (std::size_t i = 0; i < record.probes.size(); ++i)
    header.push_back(
        with_unit(fmt::format("peak {}", i + 1), probe_unit(record.probes[i].quantity)));
  Table table(header);
  std::size_t impacts = 0;
  for (std::size_t first = 0, last = 0; first < record.runs.size(); first = last + 1) {
    last = first;
    while (last + 1 < record.runs.size() && is_alike(record.runs[first], record.runs[last + 1]))
      ++last;
    table.add(range_row(record, first, last));
    impacts += (last - first + 1) * record.runs[first].impacts.size();
  }
  std::string text = fmt::format("runs of {:g} s over {}, each from the scene's initial state\n",
                                 record.duration, record.parameter);
  if (!table.empty()) text += table.text() + "\n";
  text += fmt::format("{} values, {} impacts\n", record.runs.size(), impacts);
  if (!record.outcome.message.empty())
    text += fmt::format("{}: {}\n", record.outcome.name, record.outcome.message);
  return text;
}

}  // namespace graze
