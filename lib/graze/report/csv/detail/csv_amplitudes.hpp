// How large motions are, as columns of a table: of every place, then of every stop.
#pragma once

#include <string>
#include <vector>

#include "graze/assembly/probes.hpp"
#include "graze/motion/amplitudes.hpp"
#include "graze/report/csv/result_table.hpp"

namespace graze {

// Their names, each with a comma before it; none without places.
std::string amplitude_columns(const std::vector<MeasuredPlace>& places);
// Adds their cells to a row, without values where nothing was measured.
void add_amplitudes(const std::vector<MeasuredPlace>& places, const Amplitudes* measured,
                    ResultTable& table);

}  // namespace graze
