#include "graze/record/stored/detail/record_text.hpp"

#include "graze/record/detail/run_diagram_record.hpp"
#include "graze/record/detail/sensitivity_record.hpp"
#include "graze/record/stored/detail/record_fields.hpp"

namespace graze {

std::string record_text(const SimulationRecord& record) { return value_text(record); }
std::string record_text(const RunDiagramRecord& record) { return value_text(record); }
std::string record_text(const MapRecord& record) { return value_text(record); }
std::string record_text(const ComparisonRecord& record) { return value_text(record); }
std::string record_text(const ComparisonMapRecord& record) { return value_text(record); }
std::string record_text(const SensitivityRecord& record) { return value_text(record); }

bool read_record_text(std::string_view text, SimulationRecord& record) {
  return read_value(text, record);
}
bool read_record_text(std::string_view text, RunDiagramRecord& record) {
  return read_value(text, record);
}
bool read_record_text(std::string_view text, MapRecord& record) { return read_value(text, record); }
bool read_record_text(std::string_view text, ComparisonRecord& record) {
  return read_value(text, record);
}
bool read_record_text(std::string_view text, ComparisonMapRecord& record) {
  return read_value(text, record);
}
bool read_record_text(std::string_view text, SensitivityRecord& record) {
  return read_value(text, record);
}

}  // namespace graze
