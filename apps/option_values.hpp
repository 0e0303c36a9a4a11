// What the value of an option may be, each with the sentence that refuses any other.
#pragma once

#include <optional>
#include <string>

#include "options/option.hpp"

namespace graze {

// Returns nullopt if the text is not exactly one finite number.
std::optional<double> number_in(const std::string& text);

// Of a size that scenes allow too.
ValueCheck finite_number();
ValueCheck above_zero();
// `what` names the numbers that are allowed.
ValueCheck at_least(const std::string& what, double least);
// A whole number; 1e3 for 1000 is one too, and then written out.
ValueCheck whole_number(const std::string& what, double least, double most);
ValueCheck whole_number_within(int least, int most);
// Impacts of an orbit from 0 or 1 on up to so many, or "any".
ValueCheck impacts_or_any(int least, double most);
// "strobe" is what the section stroboscopic was called before 0.1.0.
ValueCheck former_section_name();

// Beyond the cores of any machine, and short of what a process may start.
inline constexpr double kMostThreads = 1024.0;
// What the counts can hold.
inline constexpr double kMostPeriods = 0x1p30;
inline constexpr double kMostCounted = 0x1p62;

}  // namespace graze
