// The sentences below a table.
#pragma once

#include <string>
#include <vector>

#include "graze/record/records.hpp"
#include "graze/report/text/text.hpp"

namespace graze {

// What is missing, as one line; "" where all went well.
std::string ending(const Outcome& outcome);

// A line a note, then those about the numerics where they are wanted.
std::string notes_text(const std::vector<std::string>& notes,
                       const std::vector<std::string>& details, const TextOptions& options);

}  // namespace graze
