// Numbers with their unit, as people write them: "1.05 mm", "4.5 Hz", "205 GPa".
#pragma once

#include <string>
#include <string_view>
#include <variant>

namespace graze {

// Whether a text begins like a number, so that it is meant as a quantity.
bool begins_with_number(std::string_view text);

// The unit of a quantity, "mm" of "1.05 mm"; "" where it has none.
std::string unit_behind_number(const std::string& text);

// Whether it is a product of units that this table has: "N s/m^2"; "" of a pure number, too.
bool is_unit(std::string_view text);

// The number of a quantity in `unit`, or a sentence that says why there is none;
// an empty one where it is a pure number, which should not be a text.
std::variant<double, std::string> quantity_in(const std::string& text, const std::string& unit);

}  // namespace graze
