#include "graze/record/stored/record_text.hpp"

#include "graze/record/stored/detail/record_fields.hpp"
#include "graze/record/study_records.hpp"

namespace graze {

template std::string record_text(const CheckRecord&);
template bool read_record_text(std::string_view, CheckRecord&);
template std::string record_text(const CostRecord&);
template bool read_record_text(std::string_view, CostRecord&);
template std::string record_text(const ModesRecord&);
template bool read_record_text(std::string_view, ModesRecord&);
template std::string record_text(const FitRecord&);
template bool read_record_text(std::string_view, FitRecord&);

}  // namespace graze
