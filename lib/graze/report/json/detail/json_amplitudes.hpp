// Private to this room. How large motions are, at places and at stops.
#pragma once

#include "graze/assembly/probes.hpp"
#include "graze/motion/amplitudes.hpp"
#include "graze/report/json/detail/json_value.hpp"

namespace graze {

// Adds "amplitudes", one entry a place, and "loads", one a stop.
void add_amplitudes(const std::vector<MeasuredPlace>& places, const Amplitudes& measured,
                    Json& json);

// The units of both, beside others.
void add_amplitude_units(const std::vector<MeasuredPlace>& places, Json& units);
// Of the stops' part of it.
void add_load_units(Json& units);

}  // namespace graze
