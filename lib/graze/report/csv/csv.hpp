// The results as tables, which become comma-separated text: header row first, no comment lines,
// numbers with all their digits, empty cells for missing values. Units are in result.json.
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
// Writes the numbers of that row after its kind, NaN for missing values, from `row` on, which has
// space for them.
inline constexpr std::size_t kEventNumbers = 13;
void write_event_row(const Event& event, double* row);
ResultTable events_table(const std::vector<Event>& events);
// With `energy` the entries of the energy balance follow, then the probes.
std::vector<std::string> sample_columns(const System& system, bool energy,
                                        const std::vector<ProbeRow>& probes = {});
std::string samples_csv_header(const System& system, bool energy,
                               const std::vector<ProbeRow>& probes = {});
std::string samples_csv_row(const System& system, const Sample& sample,
                            const std::vector<ProbeRow>& probes = {});
// Writes the numbers of that row, NaN for missing values, from `row` on, which has space for them;
// returns their end.
double* write_sample_row(const System& system, const Sample& sample,
                         const std::vector<ProbeRow>& probes, double* row);
// How many there are.
std::size_t sample_numbers(const System& system, const Sample& sample,
                           const std::vector<ProbeRow>& probes);

// The name of a table, "branches", and the function that makes it from its record.
struct NamedTable {
  std::string name;
  std::function<ResultTable()> make;
};
// All tables of a description (result_visitor.hpp); they refer to the record. For a run without its
// events and samples, which are written to tables as they come.
template <class Record>
std::vector<NamedTable> tables_of(const Record& record);
// The table of that name; nullopt when there is none.
std::optional<ResultTable> made_table(const std::vector<NamedTable>& tables, std::string_view name);

}  // namespace graze
