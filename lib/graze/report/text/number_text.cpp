#include "graze/report/text/detail/number_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace graze {
namespace {

// A text of which every digit is 0 is that of zero.
std::string zero_or(const std::string& text) {
  return text.find_first_not_of("-+0.e") == std::string::npos ? "0" : text;
}

}  // namespace

std::string digits_text(double value, int digits, double size) {
  if (std::abs(value) <= kNoiseOfNumbers * size) return "0";
  return zero_or(fmt::format("{:.{}g}", value, digits));
}

std::string decimals_text(double value, int decimals) {
  return zero_or(fmt::format("{:.{}f}", value, decimals));
}

std::string power_text(double value, int decimals) {
  return value == 0.0 ? "0" : fmt::format("{:.{}e}", value, decimals);
}

std::string digits_text(const std::optional<double>& value, int digits, double size) {
  return value ? digits_text(*value, digits, size) : "-";
}

std::string complex_text(std::complex<double> z, int digits) {
  const double size = std::abs(z);
  const std::string real = digits_text(z.real(), digits, size);
  if (std::abs(z.imag()) <= kNoiseOfNumbers * size) return real;
  return fmt::format("{} {} {}i", real, z.imag() < 0.0 ? "-" : "+",
                     digits_text(std::abs(z.imag()), digits));
}

std::string quantity_text(double value, int digits, const std::string& unit) {
  return digits_text(value, digits) + (unit.empty() ? "" : " " + unit);
}

}  // namespace graze
