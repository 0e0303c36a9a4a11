#include "tables.hpp"

#include "graze/record/detail/comparison_record.hpp"
#include "graze/record/detail/cost_record.hpp"
#include "graze/record/detail/diagram_record.hpp"
#include "graze/record/detail/fit_record.hpp"
#include "graze/record/detail/loci_record.hpp"
#include "graze/record/detail/map_record.hpp"
#include "graze/record/detail/modes_record.hpp"
#include "graze/record/detail/run_diagram_record.hpp"
#include "graze/record/detail/sensitivity_record.hpp"
#include "graze/report/csv/csv.hpp"

namespace graze {

std::vector<Table> tables_of(const CheckRecord&) { return {}; }

std::vector<Table> tables_of(const ModesRecord&) { return {}; }

std::vector<Table> tables_of(const SimulationRecord& record) {
  std::vector<Table> tables;
  if (record.section)
    tables.push_back({"section.csv", [&] { return section_table(*record.section); }});
  if (record.run.amplitudes && record.run.amplitudes->forces)
    tables.push_back({"forces.csv", [&] { return forces_table(*record.run.amplitudes->forces); }});
  return tables;
}

std::vector<Table> tables_of(const OrbitRecord& record) {
  return {{"orbits.csv", [&] { return orbits_table(record); }},
          {"profiles.csv", [&] { return profiles_table(record); }},
          {"stuck.csv", [&] { return stuck_table(record); }},
          {"contacts.csv", [&] { return contacts_table(record); }}};
}

std::vector<Table> tables_of(const BranchRecord& record) {
  return {{"branches.csv", [&] { return branches_table(record); }},
          {"special.csv", [&] { return special_table(record); }}};
}

std::vector<Table> tables_of(const LociRecord& record) {
  std::vector<Table> tables = {{"loci.csv", [&] { return loci_table(record.traced); }},
                               {"special.csv", [&] { return special_table(record); }}};
  if (record.regions)
    tables.push_back({"regions.csv", [&] { return regions_table(*record.regions); }});
  return tables;
}

std::vector<Table> tables_of(const DiagramRecord& record) {
  std::vector<Table> tables = {{"sweep.csv", [&] { return sweep_table(record); }}};
  for (Table& table : tables_of(record.branches)) tables.push_back(std::move(table));
  if (record.swept.options.exponent_periods > 0)
    tables.push_back({"exponents.csv", [&] { return exponents_table(record); }});
  return tables;
}

std::vector<Table> tables_of(const RunDiagramRecord& record) {
  return {{"sweep.csv", [&] { return run_impacts_table(record); }},
          {"runs.csv", [&] { return runs_table(record); }}};
}

std::vector<Table> tables_of(const MapRecord& record) {
  std::vector<Table> tables = {{"map.csv", [&] { return map_table(record); }}};
  if (record.loci) tables.push_back({"loci.csv", [&] { return loci_table(*record.loci); }});
  return tables;
}

std::vector<Table> tables_of(const ComparisonRecord& record) {
  return {{"comparison.csv", [&] { return comparison_table(record); }},
          {"first_impacts.csv", [&] { return first_impacts_table(record); }}};
}

std::vector<Table> tables_of(const ComparisonMapRecord& record) {
  return {{"comparison.csv", [&] { return comparison_table(record); }}};
}

std::vector<Table> tables_of(const SensitivityRecord& record) {
  return {{"sensitivity.csv", [&] { return sensitivity_table(record); }}};
}

std::vector<Table> tables_of(const CostRecord& record) {
  return {{"costs.csv", [&] { return costs_table(record); }},
          {"costs_of_modes.csv", [&] { return mode_costs_table(record); }},
          {"costs_of_closure.csv", [&] { return closure_costs_table(record); }},
          {"costs_of_corrector.csv", [&] { return corrector_costs_table(record); }},
          {"costs_of_contact.csv", [&] { return contact_orders_table(record); }}};
}

std::vector<Table> tables_of(const FitRecord& record) {
  return {{"fit.csv", [&] { return fit_table(record); }},
          {"parameters.csv", [&] { return parameters_table(record); }}};
}

}  // namespace graze
