// Whether numbers have SI units or none, and the units of what is told of them.
#pragma once

#include <string>

namespace graze {

enum class Units { kSi, kNone };

// A unit as results are told in: itself, "" where numbers are pure.
inline std::string unit_in(Units units, const std::string& unit) {
  return units == Units::kSi ? unit : "";
}

// Behind a number in a sentence, with the space between: " s", "" where numbers are pure.
inline std::string unit_behind(Units units, const std::string& unit) {
  return units == Units::kSi ? " " + unit : "";
}

}  // namespace graze
