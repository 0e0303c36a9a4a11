// Numbers in tables. Zero is "0", whatever its sign and the number of digits.
#pragma once

#include <complex>
#include <optional>
#include <string>

namespace graze {

// Relative to the size of other numbers, a number smaller than this is their rounding: some hundred
// operations of 2e-16 each.
inline constexpr double kNoiseOfNumbers = 1e-14;

// With this number of digits, "0.135344897739". A number within the noise of `size` is zero.
std::string digits_text(double value, int digits, double size = 0.0);
// With so many decimals, "3.141592654".
std::string decimals_text(double value, int decimals);
// With a power of ten, "7.9600e-07".
std::string power_text(double value, int decimals);

// With digits, "-" for nullopt.
std::string digits_text(const std::optional<double>& value, int digits, double size = 0.0);

// "0.22 - 0.77i"; a real number where the imaginary part is noise.
std::string complex_text(std::complex<double> z, int digits);

// "0.0012 m"; the number alone where it has no unit.
std::string quantity_text(double value, int digits, const std::string& unit);

}  // namespace graze
