// The same results as comma-separated tables: header row first, no comment lines, numbers with all
// their digits, empty cells for what does not exist. Units stand in result.json.
#pragma once

#include <string>

#include "graze/record/records.hpp"

namespace graze {

std::string events_csv(const SimulationRecord& record);
std::string samples_csv(const SimulationRecord& record);
std::string orbits_csv(const OrbitRecord& record);
std::string branches_csv(const BranchRecord& record);
std::string special_csv(const BranchRecord& record);

}  // namespace graze
