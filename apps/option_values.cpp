#include "option_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "graze/scene/value_checker.hpp"

namespace graze {
namespace {

template <class Fits>
ValueCheck number(const std::string& what, const Fits& fits) {
  return [what, fits](std::string& text) {
    const std::optional<double> value = number_in(text);
    return value && fits(*value) ? std::string() : fmt::format("'{}' is not {}", text, what);
  };
}

}  // namespace

std::optional<double> number_in(const std::string& text) {
  if (text.empty()) return {};
  char* end = nullptr;
  const auto value = static_cast<double>(std::strtold(text.c_str(), &end));
  if (end != text.c_str() + text.size() || !std::isfinite(value)) return {};
  return value;
}

ValueCheck finite_number() {
  return [](std::string& text) {
    const std::optional<double> value = number_in(text);
    if (!value) return fmt::format("'{}' is not a finite number", text);
    return std::abs(*value) <= kLargestNumber
               ? std::string()
               : fmt::format("'{}' is not a number of at most {:.1e} in size", text,
                             kLargestNumber);
  };
}

ValueCheck above_zero() {
  return number("a number above 0", [](double value) { return value > 0.0; });
}

ValueCheck at_least(const std::string& what, double least) {
  return number(what, [least](double value) { return value >= least; });
}

ValueCheck whole_number(const std::string& what, double least, double most) {
  return [what, least, most](std::string& text) {
    const std::optional<double> value = number_in(text);
    if (!value || !(*value >= least && *value <= most) || *value != std::floor(*value))
      return fmt::format("'{}' is not {}", text, what);
    if (text.find_first_of(".eE") != std::string::npos) text = fmt::format("{:.0f}", *value);
    return std::string();
  };
}

ValueCheck whole_number_within(int least, int most) {
  return whole_number(fmt::format("a whole number from {} to {}", least, most), least, most);
}

ValueCheck impacts_or_any(int least, double most) {
  const std::string highest = most < kMostPeriods ? fmt::format(" to {:g}", most) : std::string();
  const ValueCheck number =
      whole_number(fmt::format("a whole number from {}{}, or 'any'", least, highest), least, most);
  return [number](std::string& text) { return text == "any" ? std::string() : number(text); };
}

ValueCheck former_section_name() {
  return [](std::string& text) {
    if (text == "strobe") text = "stroboscopic";
    return std::string();
  };
}

}  // namespace graze
