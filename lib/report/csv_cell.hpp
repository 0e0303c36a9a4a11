// A number in a table.
#pragma once

#include <string>

namespace graze {

// All its digits, or nothing where it is none.
std::string csv_cell(double value);

}  // namespace graze
