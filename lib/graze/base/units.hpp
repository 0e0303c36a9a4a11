// Whether numbers have SI units or none, and the units of reported quantities.
#pragma once

#include <string>

namespace graze {

enum class Units { kSi, kNone };

// The unit to report: `unit` itself, "" where numbers are pure.
inline std::string unit_in(Units units, const std::string& unit) {
  return units == Units::kSi ? unit : "";
}

// What follows a number in a sentence, with the space between: " s", "" where numbers are pure.
inline std::string unit_behind(Units units, const std::string& unit) {
  return units == Units::kSi ? " " + unit : "";
}

}  // namespace graze
