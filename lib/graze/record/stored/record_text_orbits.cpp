#include "graze/record/stored/record_text.hpp"

#include "graze/record/stored/detail/record_fields.hpp"
#include "graze/record/study_records.hpp"

namespace graze {

template std::string record_text(const OrbitRecord&);
template bool read_record_text(std::string_view, OrbitRecord&);
template std::string record_text(const BranchRecord&);
template bool read_record_text(std::string_view, BranchRecord&);
template std::string record_text(const LociRecord&);
template bool read_record_text(std::string_view, LociRecord&);
template std::string record_text(const DiagramRecord&);
template bool read_record_text(std::string_view, DiagramRecord&);

}  // namespace graze
