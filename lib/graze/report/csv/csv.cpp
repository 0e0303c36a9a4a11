#include "graze/report/csv/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "graze/record/described/detail/descriptions.hpp"
#include "graze/record/names/motion_names.hpp"
#include "graze/record/records.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/csv/detail/table_builder.hpp"
#include "graze/system/detail/hub_state.hpp"

namespace graze {

namespace {

std::string csv_cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

// The cells of an event's row after its kind.
class EventNumbers : public ResultVisitor {
 public:
  explicit EventNumbers(double* row) : row_(row) { std::fill_n(row, kEventNumbers, NAN); }

 protected:
  bool open(const Field&, Shape) override { return true; }
  void close() override {}
  void take(const Field& field, const FieldValue& value) override {
    static const std::vector<std::string> names = [] {
      const ResultTable table = events_table({});
      std::vector<std::string> list;
      for (const ColumnBuilder& column : table.columns()) list.push_back(column.column().name);
      return list;
    }();
    // Names come in their order, with some left out.
    while (names[column_] != field.name) ++column_;
    if (column_ == 0) return;
    if (const auto* whole = std::get_if<long long>(&value))
      row_[column_ - 1] = static_cast<double>(*whole);
    else if (const auto* number = std::get_if<double>(&value))
      row_[column_ - 1] = *number;
  }

 private:
  double* row_;
  std::size_t column_ = 0;
};

}  // namespace

std::string events_csv_header() { return csv_text(events_table({})); }

void write_event_row(const Event& event, double* row) {
  EventNumbers numbers(row);
  describe(numbers, event);
}

std::string events_csv_row(const Event& event) {
  std::array<double, kEventNumbers> row{};
  write_event_row(event, row.data());
  std::string text = name_of(event.kind);
  for (const double value : row) fmt::format_to(std::back_inserter(text), ",{}", csv_cell(value));
  return text + "\n";
}

ResultTable events_table(const std::vector<Event>& events) {
  return built_table("events", [&](ResultVisitor& v) { describe(v, events); });
}

std::vector<std::string> sample_columns(const System& system, bool energy,
                                        const std::vector<ProbeRow>& probes) {
  std::vector<std::string> names = {"time"};
  const auto add = [&](const char* name, std::size_t count) {
    for (std::size_t i = 1; i <= count; ++i) names.push_back(fmt::format("{}{}", name, i));
  };
  if (system.turns()) names.insert(names.end(), {"angle", "rate"});
  const auto modes = static_cast<std::size_t>(system.modes() - (system.turns() ? 1 : 0));
  add("q", modes);
  add("qdot", modes);
  add("gap", system.stops.size());
  add("force", system.stops.size());
  add("friction", system.frictions.size());
  if (energy)
    names.insert(names.end(), {"energy", "work_forcing", "work_load", "work_constraint",
                               "work_impacts", "dissipation", "work_contact"});
  if (energy && !system.frictions.empty()) names.emplace_back("work_friction");
  add("probe_", probes.size());
  return names;
}

std::string samples_csv_header(const System& system, bool energy,
                               const std::vector<ProbeRow>& probes) {
  return fmt::format("{}\n", fmt::join(sample_columns(system, energy, probes), ","));
}

std::size_t sample_numbers(const System& system, const Sample& sample,
                           const std::vector<ProbeRow>& probes) {
  const std::size_t energies = system.frictions.empty() ? 7 : 8;
  return 1 + 2 * static_cast<std::size_t>(sample.state.q.size()) + system.stops.size() +
         sample.forces.size() + sample.frictions.size() + (sample.energy ? energies : 0) +
         probes.size();
}

double* write_sample_row(const System& system, const Sample& sample,
                         const std::vector<ProbeRow>& probes, double* row) {
  const auto add = [&](const std::optional<double>& value) { *row++ = value.value_or(NAN); };
  State carried;
  if (system.carried()) carried = structure_state(system, sample.state, sample.phase);
  const State& own = system.carried() ? carried : sample.state;
  const auto add_state = [&](const State& state) {
    row = std::copy(state.q.begin(), state.q.end(), row);
    row = std::copy(state.qdot.begin(), state.qdot.end(), row);
  };
  *row++ = sample.time;
  if (system.turns()) {
    const HubState hub = hub_state(*system.rotation(), sample.state);
    *row++ = hub.angle;
    *row++ = hub.rate;
    add_state(hub.beam);
  } else {
    add_state(own);
  }
  for (const Stop& stop : system.stops) *row++ = stop.gap - stop.row.dot(sample.state.q);
  row = std::copy(sample.forces.begin(), sample.forces.end(), row);
  row = std::copy(sample.frictions.begin(), sample.frictions.end(), row);
  if (sample.energy) {
    const EnergyEntries entries = energy_entries(system, *sample.energy);
    *row++ = sample.energy->now;
    add(entries.forcing);
    add(entries.load);
    add(entries.constraint);
    add(entries.impacts);
    add(entries.dissipation);
    add(entries.contact);
    if (!system.frictions.empty()) add(entries.friction);
  }
  for (const ProbeRow& probe : probes) *row++ = probe.value(own);
  return row;
}

std::string samples_csv_row(const System& system, const Sample& sample,
                            const std::vector<ProbeRow>& probes) {
  std::vector<double> row(sample_numbers(system, sample, probes));
  write_sample_row(system, sample, probes, row.data());
  std::string text = csv_cell(row.front());
  for (std::size_t i = 1; i < row.size(); ++i)
    fmt::format_to(std::back_inserter(text), ",{}", csv_cell(row[i]));
  return text + "\n";
}

template <class Record>
std::vector<NamedTable> tables_of(const Record& record) {
  TableNames names;
  describe(names, record);
  std::vector<NamedTable> tables;
  for (const std::string& name : names.names())
    tables.push_back({name, [name, &record] {
                        return built_table(name, [&](ResultVisitor& v) { describe(v, record); });
                      }});
  return tables;
}

std::optional<ResultTable> made_table(const std::vector<NamedTable>& tables,
                                      std::string_view name) {
  for (const NamedTable& table : tables)
    if (table.name == name) return table.make();
  return {};
}

template std::vector<NamedTable> tables_of(const CheckRecord&);
template std::vector<NamedTable> tables_of(const ModesRecord&);
template std::vector<NamedTable> tables_of(const SimulationRecord&);
template std::vector<NamedTable> tables_of(const OrbitRecord&);
template std::vector<NamedTable> tables_of(const BranchRecord&);
template std::vector<NamedTable> tables_of(const LociRecord&);
template std::vector<NamedTable> tables_of(const DiagramRecord&);
template std::vector<NamedTable> tables_of(const RunDiagramRecord&);
template std::vector<NamedTable> tables_of(const MapRecord&);
template std::vector<NamedTable> tables_of(const ComparisonRecord&);
template std::vector<NamedTable> tables_of(const ComparisonMapRecord&);
template std::vector<NamedTable> tables_of(const SensitivityRecord&);
template std::vector<NamedTable> tables_of(const CostRecord&);
template std::vector<NamedTable> tables_of(const FitRecord&);

}  // namespace graze
