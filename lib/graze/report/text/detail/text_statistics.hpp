// Private to this room. The statistics of a run.
#pragma once

#include <string>

#include "graze/record/records.hpp"
#include "graze/report/text/text.hpp"

namespace graze {

// Tables of places, stops and histograms, and a sentence about the spectra. The record has
// statistics.
std::string statistics_text(const SimulationRecord& record, const TextOptions& options);

}  // namespace graze
