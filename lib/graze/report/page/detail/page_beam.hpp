// The beam over its length at every sample of a run, for the page that shows it moving.
#pragma once

#include "graze/record/records.hpp"
#include "graze/report/json/detail/json_value.hpp"

namespace graze {

// Null where the record has no beam or no samples.
Json beam_json(const SimulationRecord& record);

}  // namespace graze
