// The tables of each result: what stands in the files that --out writes beside the document.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "graze/record/record_names.hpp"
#include "graze/report/csv/result_table.hpp"

namespace graze {

// The name of its file, "branches.csv", and what makes it, from the record that it is of.
struct Table {
  std::string name;
  std::function<ResultTable()> make;
};

// All must be used before the record goes.
std::vector<Table> tables_of(const CheckRecord& record);
std::vector<Table> tables_of(const ModesRecord& record);
// Without its events and samples, which go into tables as they come.
std::vector<Table> tables_of(const SimulationRecord& record);
std::vector<Table> tables_of(const OrbitRecord& record);
std::vector<Table> tables_of(const BranchRecord& record);
std::vector<Table> tables_of(const LociRecord& record);
std::vector<Table> tables_of(const DiagramRecord& record);
std::vector<Table> tables_of(const RunDiagramRecord& record);
std::vector<Table> tables_of(const MapRecord& record);
std::vector<Table> tables_of(const ComparisonRecord& record);
std::vector<Table> tables_of(const ComparisonMapRecord& record);
std::vector<Table> tables_of(const SensitivityRecord& record);
std::vector<Table> tables_of(const CostRecord& record);
std::vector<Table> tables_of(const FitRecord& record);

}  // namespace graze
