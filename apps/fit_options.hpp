// Options of `graze fit` from their words.
#pragma once

#include <string>
#include <vector>

#include "command.hpp"
#include "graze/fit/fit.hpp"
#include "graze/fit/measurements.hpp"

namespace graze {

// Each "NAME=LOW:HIGH", or "NAME" alone without limits. Throws InputError.
std::vector<SoughtParameter> sought_parameters(const std::vector<std::string>& words);

// --column, and --sigma with "VALUE" or "COLUMN=VALUE". Throws InputError.
MeasurementOptions measurement_options(const FitCommand& command);

}  // namespace graze
