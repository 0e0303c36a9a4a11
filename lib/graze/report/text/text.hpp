// Results in words and tables, for a terminal.
#pragma once

#include <string>

#include "graze/record/record_names.hpp"

namespace graze {

std::string to_text(const CheckRecord& record);
std::string to_text(const SimulationRecord& record);
std::string to_text(const OrbitRecord& record);
std::string to_text(const BranchRecord& record);
std::string to_text(const LociRecord& record);
std::string regions_text(const LociRecord& record);  // requires regions
std::string to_text(const DiagramRecord& record);
std::string to_text(const RunDiagramRecord& record);
std::string to_text(const MapRecord& record);
std::string to_text(const ComparisonRecord& record);
std::string to_text(const ComparisonMapRecord& record);
std::string to_text(const ShareRecord& record);
std::string to_text(const CostRecord& record);
std::string to_text(const FitRecord& record);
std::string to_text(const SensitivityRecord& record);

}  // namespace graze
