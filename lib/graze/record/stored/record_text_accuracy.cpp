#include "graze/record/stored/detail/record_text.hpp"

#include "graze/record/detail/cost_record.hpp"
#include "graze/record/detail/fit_record.hpp"
#include "graze/record/stored/detail/record_fields.hpp"

namespace graze {

std::string record_text(const CheckRecord& record) { return value_text(record); }
std::string record_text(const CostRecord& record) { return value_text(record); }
std::string record_text(const FitRecord& record) { return value_text(record); }

bool read_record_text(std::string_view text, CheckRecord& record) {
  return read_value(text, record);
}
bool read_record_text(std::string_view text, CostRecord& record) {
  return read_value(text, record);
}
bool read_record_text(std::string_view text, FitRecord& record) { return read_value(text, record); }

}  // namespace graze
