#include "graze/record/stored/record_text.hpp"

#include "graze/record/stored/detail/record_fields.hpp"
#include "graze/record/study_records.hpp"

namespace graze {

template std::string record_text(const SimulationRecord&);
template bool read_record_text(std::string_view, SimulationRecord&);
template std::string record_text(const RunDiagramRecord&);
template bool read_record_text(std::string_view, RunDiagramRecord&);
template std::string record_text(const MapRecord&);
template bool read_record_text(std::string_view, MapRecord&);
template std::string record_text(const ComparisonRecord&);
template bool read_record_text(std::string_view, ComparisonRecord&);
template std::string record_text(const ComparisonMapRecord&);
template bool read_record_text(std::string_view, ComparisonMapRecord&);
template std::string record_text(const SensitivityRecord&);
template bool read_record_text(std::string_view, SensitivityRecord&);

}  // namespace graze
