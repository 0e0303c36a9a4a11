#include "graze/record/stored/detail/record_text.hpp"

#include "graze/record/detail/loci_record.hpp"
#include "graze/record/stored/detail/record_fields.hpp"

namespace graze {

std::string record_text(const OrbitRecord& record) { return value_text(record); }
std::string record_text(const BranchRecord& record) { return value_text(record); }
std::string record_text(const LociRecord& record) { return value_text(record); }
std::string record_text(const DiagramRecord& record) { return value_text(record); }

bool read_record_text(std::string_view text, OrbitRecord& record) {
  return read_value(text, record);
}
bool read_record_text(std::string_view text, BranchRecord& record) {
  return read_value(text, record);
}
bool read_record_text(std::string_view text, LociRecord& record) {
  return read_value(text, record);
}
bool read_record_text(std::string_view text, DiagramRecord& record) {
  return read_value(text, record);
}

}  // namespace graze
