// Numbers of orbits by the names that --level and --extreme give them: what response curves show
// (shown_quantity.hpp), and what an orbit has besides.
#pragma once

#include <string>
#include <vector>

#include "graze/assembly/probes.hpp"
#include "graze/bifurcation/problem/orbit_level.hpp"
#include "graze/record/shown_quantity.hpp"

namespace graze {

// What a response curve shows, of an orbit.
OrbitNumber number_of(const Shown& shown);

// "probe.1.amplitude=2e-3" of a level, "stop.2.peak-force" of an extreme; where it names no place
// the number is that at `at`, or at the first place that has it. Throws InputError, with what is
// allowed.
OrbitLevel level_named(const std::string& text, bool is_extreme, const std::string& at,
                       const std::vector<MeasuredPlace>& places);

}  // namespace graze
