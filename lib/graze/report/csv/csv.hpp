// The results as tables, which become comma-separated text: header row first, no comment lines,
// numbers with all their digits, empty cells for what does not exist. Units stand in result.json.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graze/assembly/probes.hpp"
#include "graze/motion/run_events.hpp"
#include "graze/record/record_names.hpp"
#include "graze/report/csv/result_table.hpp"

namespace graze {

// Tables of a run grow row by row, so header and rows come apart.
std::string events_csv_header();
std::string events_csv_row(const Event& event);
// The numbers of that row behind its kind, NaN for what does not exist, from `row` on, which has
// room for them.
inline constexpr std::size_t kEventNumbers = 11;
void write_event_row(const Event& event, double* row);
ResultTable events_table(const std::vector<Event>& events);
// With `energy` the entries of the energy balance follow, then the probes.
std::vector<std::string> sample_columns(const System& system, bool energy,
                                        const std::vector<ProbeRow>& probes = {});
std::string samples_csv_header(const System& system, bool energy,
                               const std::vector<ProbeRow>& probes = {});
std::string samples_csv_row(const System& system, const Sample& sample,
                            const std::vector<ProbeRow>& probes = {});
// The numbers of that row, NaN for what does not exist, from `row` on, which has room for them;
// returns the end of them.
double* write_sample_row(const System& system, const Sample& sample,
                         const std::vector<ProbeRow>& probes, double* row);
// How many there are.
std::size_t sample_numbers(const System& system, const Sample& sample,
                           const std::vector<ProbeRow>& probes);

// The name of a table, "branches", and what makes it, from the record that it is of.
struct NamedTable {
  std::string name;
  std::function<ResultTable()> make;
};
// All that are described (result_visitor.hpp), to be used before the record goes. Of a run without
// its events and samples, which go into tables as they come.
template <class Record>
std::vector<NamedTable> tables_of(const Record& record);
// The one of that name.
std::optional<ResultTable> made_table(const std::vector<NamedTable>& tables, std::string_view name);

}  // namespace graze
