// The sentences below a table.
#pragma once

#include <string>
#include <vector>

#include "graze/record/records.hpp"
#include "graze/report/text/text.hpp"

namespace graze {

// The missing part of the result, as one line; "" when nothing is missing.
std::string ending(const Outcome& outcome);

// A line for each note, then those about the numerics if they are wanted.
std::string notes_text(const std::vector<std::string>& notes,
                       const std::vector<std::string>& details, const TextOptions& options);

}  // namespace graze
