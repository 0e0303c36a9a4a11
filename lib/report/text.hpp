// Results in words and tables, for a terminal.
#pragma once

#include <string>

#include "graze/record/records.hpp"

namespace graze {

std::string to_text(const CheckRecord& record);
std::string to_text(const SimulationRecord& record);
std::string to_text(const OrbitRecord& record);
std::string to_text(const BranchRecord& record);

}  // namespace graze
