// Records as text that reads back to the last bit, for files to draw from again: all they hold but
// what follows from the scene (record_fields.hpp).
#pragma once

#include <string>
#include <string_view>

#include "graze/record/record_names.hpp"

namespace graze {

std::string record_text(const CheckRecord& record);
std::string record_text(const SimulationRecord& record);
std::string record_text(const OrbitRecord& record);
std::string record_text(const BranchRecord& record);
std::string record_text(const LociRecord& record);
std::string record_text(const DiagramRecord& record);
std::string record_text(const RunDiagramRecord& record);
std::string record_text(const MapRecord& record);
std::string record_text(const ComparisonRecord& record);
std::string record_text(const ComparisonMapRecord& record);
std::string record_text(const SensitivityRecord& record);
std::string record_text(const CostRecord& record);
std::string record_text(const FitRecord& record);

// Reads what `record_text` wrote; without systems, and without the text of the scene. False where
// it did not write that.
bool read_record_text(std::string_view text, CheckRecord& record);
bool read_record_text(std::string_view text, SimulationRecord& record);
bool read_record_text(std::string_view text, OrbitRecord& record);
bool read_record_text(std::string_view text, BranchRecord& record);
bool read_record_text(std::string_view text, LociRecord& record);
bool read_record_text(std::string_view text, DiagramRecord& record);
bool read_record_text(std::string_view text, RunDiagramRecord& record);
bool read_record_text(std::string_view text, MapRecord& record);
bool read_record_text(std::string_view text, ComparisonRecord& record);
bool read_record_text(std::string_view text, ComparisonMapRecord& record);
bool read_record_text(std::string_view text, SensitivityRecord& record);
bool read_record_text(std::string_view text, CostRecord& record);
bool read_record_text(std::string_view text, FitRecord& record);

}  // namespace graze
