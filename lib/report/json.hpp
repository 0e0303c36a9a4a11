// The result documents: one JSON object a command, numbers with all their digits, null for what
// does not exist.
#pragma once

#include <string>

#include "graze/record/records.hpp"

namespace graze {

std::string to_json(const CheckRecord& record);
std::string to_json(const SimulationRecord& record);
std::string to_json(const OrbitRecord& record);
std::string to_json(const BranchRecord& record);

}  // namespace graze
