#include "graze/record/file/piece_text.hpp"

#include "graze/record/file/detail/fields.hpp"

namespace graze {

std::string piece_text(const SweepRow& row) { return value_text(row); }
std::string piece_text(const SettledCell& cell) { return value_text(cell); }
std::string piece_text(const ValueRun& run) { return value_text(run); }
std::string piece_text(const ComparedCell& cell) { return value_text(cell); }

bool read_piece(const std::string& text, SweepRow& row) { return read_value(text, row); }
bool read_piece(const std::string& text, SettledCell& cell) { return read_value(text, cell); }
bool read_piece(const std::string& text, ValueRun& run) { return read_value(text, run); }
bool read_piece(const std::string& text, ComparedCell& cell) { return read_value(text, cell); }

}  // namespace graze
