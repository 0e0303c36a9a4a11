// A value in a table.
#pragma once

#include <optional>
#include <string>

namespace graze {

// All its digits, or nothing where it is none.
std::string csv_cell(double value);
std::string csv_cell(const std::optional<double>& value);
std::string csv_cell(const std::optional<bool>& value);  // 1 or 0

}  // namespace graze
