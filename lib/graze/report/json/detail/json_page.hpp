// Private to this room. The data of a page (page.hpp): lists of numbers as the bytes of typed
// arrays, names without gnuplot's markup, commands for a shell, and the file itself.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "graze/record/records.hpp"
#include "graze/report/chart/axis.hpp"
#include "graze/report/json/detail/json_value.hpp"

namespace graze {

// {"f64": ".."} and so on: little-endian bytes in base 64.
Json packed(const std::vector<double>& numbers);
Json packed(const std::vector<float>& numbers);
Json packed(const std::vector<std::int32_t>& numbers);
Json packed(const std::vector<std::uint8_t>& numbers);

// A quantity with its axis: name, unit, SI unit, factor (from SI to the unit) and the range, SI,
// with a part of it more on both sides.
Json page_axis(const std::string& name, const std::string& si_unit, AxisRange range,
               double margin = 0.05);

// "graze orbit SCENE --set .." with the settings of the run; "name=value" of `more` come after.
std::string page_command(const RunInfo& info, const std::string& command,
                         const std::vector<std::string>& more);

// The common beginning of pages: head of the document, notes, the command. `warnings` and `notes`
// are the record's.
Json page_view(const RunInfo& info, const Outcome& outcome,
               const std::vector<std::string>& warnings, const std::vector<std::string>& notes);

// Puts the view and the orbits into the page, and writes the file.
void write_page_file(const std::string& file, const Json& view, const Json& orbits);

}  // namespace graze
