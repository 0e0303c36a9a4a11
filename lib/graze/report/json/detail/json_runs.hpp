// Private to this room. Single runs over a parameter, as documents hold them.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "graze/scene/scene.hpp"
#include "graze/study/sweep/detail/run_series.hpp"

namespace graze {

// value, reached_end, impacts (time, stop, speed), peaks and ends of the probes.
nlohmann::ordered_json run_json(const ValueRun& run);

// quantity, unit and position of each.
nlohmann::ordered_json probes_json(const std::vector<Probe>& probes);

}  // namespace graze
