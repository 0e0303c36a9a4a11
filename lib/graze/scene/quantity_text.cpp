#include "graze/scene/detail/quantity_text.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "graze/base/angle.hpp"
#include "graze/scene/suggestion.hpp"

namespace graze {
namespace {

// How large a unit is, and the powers of kg, m, s and rad in it, doubled: modal coordinates have
// kg^1/2. An angle is told from a number, so that Hz and rad/s differ by a turn.
struct Size {
  double factor = 1.0;
  std::array<int, 4> powers{};
};

struct NamedUnit {
  std::string_view name;
  bool has_prefixes;
  Size size;
};

constexpr std::array<int, 4> kForce{2, 2, -4, 0}, kPressure{2, -2, -4, 0}, kEnergy{2, 4, -4, 0};
// Inch, foot and pound are exact (NIST Special Publication 811 (2008), appendix B.8), the pound's
// force by the standard acceleration of gravity 9.80665 m/s^2.
constexpr double kPound = 0.45359237, kPoundForce = kPound * 9.80665, kInch = 0.0254;
constexpr NamedUnit kUnits[] = {
    {"m", true, {1.0, {0, 2, 0, 0}}},
    {"g", true, {1e-3, {2, 0, 0, 0}}},
    {"t", false, {1e3, {2, 0, 0, 0}}},
    {"s", true, {1.0, {0, 0, 2, 0}}},
    {"min", false, {60.0, {0, 0, 2, 0}}},
    {"h", false, {3600.0, {0, 0, 2, 0}}},
    {"rad", true, {1.0, {0, 0, 0, 2}}},
    {"deg", false, {kTurn / 360.0, {0, 0, 0, 2}}},
    {"°", false, {kTurn / 360.0, {0, 0, 0, 2}}},
    {"Hz", true, {kTurn, {0, 0, -2, 2}}},
    {"rpm", false, {kTurn / 60.0, {0, 0, -2, 2}}},
    {"N", true, {1.0, kForce}},
    {"Pa", true, {1.0, kPressure}},
    {"bar", true, {1e5, kPressure}},
    {"J", true, {1.0, kEnergy}},
    {"in", false, {kInch, {0, 2, 0, 0}}},
    {"ft", false, {12.0 * kInch, {0, 2, 0, 0}}},
    {"lb", false, {kPound, {2, 0, 0, 0}}},
    {"lbf", false, {kPoundForce, kForce}},
    {"psi", false, {kPoundForce / (kInch * kInch), kPressure}},
    {"%", false, {1e-2, {}}},
    {"1", false, {}},
};
constexpr std::pair<std::string_view, double> kPrefixes[] = {{"n", 1e-9}, {"u", 1e-6}, {"µ", 1e-6},
                                                             {"μ", 1e-6}, {"m", 1e-3}, {"c", 1e-2},
                                                             {"k", 1e3},  {"M", 1e6},  {"G", 1e9}};

std::optional<Size> named_size(std::string_view name) {
  for (const NamedUnit& unit : kUnits)
    if (unit.name == name) return unit.size;
  for (const auto& [prefix, factor] : kPrefixes)
    if (name.starts_with(prefix))
      for (const NamedUnit& unit : kUnits)
        if (unit.has_prefixes && unit.name == name.substr(prefix.size()))
          return Size{factor * unit.size.factor, unit.size.powers};
  return {};
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const NamedUnit& unit : kUnits) {
    names.emplace_back(unit.name);
    if (unit.has_prefixes)
      for (const auto& [prefix, factor] : kPrefixes)
        names.push_back(std::string(prefix) + std::string(unit.name));
  }
  return names;
}

// Takes an integer from the front; nullopt where there is none.
std::optional<int> take_integer(std::string_view& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return {};
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

// Twice the power behind a unit's name: "^2", "^-1/2", "²"; nullopt of one that is neither whole
// nor a half.
std::optional<int> take_power(std::string_view& text) {
  constexpr std::pair<std::string_view, int> kRaised[] = {{"²", 4}, {"³", 6}, {"⁴", 8}};
  for (const auto& [mark, power] : kRaised)
    if (text.starts_with(mark)) {
      text.remove_prefix(mark.size());
      return power;
    }
  if (!text.starts_with('^')) return 2;
  text.remove_prefix(1);
  const std::optional<int> whole = take_integer(text);
  if (!whole || std::abs(*whole) > 12) return {};
  if (text.starts_with("/2")) {
    text.remove_prefix(2);
    return *whole;
  }
  if (text.starts_with(".5") && *whole >= 0) {
    text.remove_prefix(2);
    return 2 * *whole + 1;
  }
  return 2 * *whole;
}

std::string unknown_unit(std::string_view name) {
  const std::string close = closest_name(std::string(name), all_names());
  return close.empty() ? fmt::format("there is no unit \"{}\"", name)
                       : fmt::format("there is no unit \"{}\", did you mean {}?", name, close);
}

// Factors behind each other multiply, and one behind a stroke divides. What stands behind that
// without another stroke could be meant either way.
std::variant<Size, std::string> size_of(std::string_view text) {
  Size size;
  bool divided = false;
  while (!text.empty()) {
    const bool over = text.starts_with('/');
    if (!over && divided)
      return fmt::format(
          "\"{}\" behind a stroke could multiply or divide: write a stroke before it, "
          "or it before the stroke",
          text);
    divided = divided || over;
    if (over) text.remove_prefix(1);
    const std::string_view name = text.substr(0, text.find_first_of(" */^"));
    // A raised number belongs to no name.
    std::string_view bare = name;
    for (const std::string_view mark : {"²", "³", "⁴"}) bare = bare.substr(0, bare.find(mark));
    const std::optional<Size> one = named_size(bare);
    if (!one) return unknown_unit(bare);
    text.remove_prefix(bare.size());
    const std::optional<int> power = take_power(text);
    if (!power) return std::string("a unit has a whole power, or a half one like kg^1/2");
    const int sign = over ? -1 : 1;
    const double factor = std::pow(one->factor, 0.5 * *power);
    size.factor = over ? size.factor / factor : size.factor * factor;
    for (std::size_t k = 0; k < size.powers.size(); ++k)
      size.powers[k] += sign * one->powers[k] * *power / 2;
    while (text.starts_with(' ') || text.starts_with('*')) text.remove_prefix(1);
  }
  return size;
}

// `value`, written as `text`, times `factor`: of a power of ten what the shifted text reads as, so
// that "1.05 mm" is 1.05e-3.
double scaled(const std::string& text, double value, double factor) {
  const double decades = std::round(std::log10(factor));
  if (std::abs(std::pow(10.0, decades) / factor - 1.0) > 1e-15) return value * factor;
  const std::size_t mark = text.find_first_of("eE");
  const int before = mark == std::string::npos ? 0 : std::stoi(text.substr(mark + 1));
  const std::string shifted =
      fmt::format("{}e{}", text.substr(0, mark), before + static_cast<int>(decades));
  double shifted_value = 0.0;
  std::from_chars(shifted.data(), shifted.data() + shifted.size(), shifted_value);
  return shifted_value;
}

}  // namespace

bool begins_with_number(std::string_view text) {
  return !text.empty() && std::string_view("+-.0123456789").find(text[0]) != std::string_view::npos;
}

std::string unit_behind_number(const std::string& text) {
  const char *from = text.data() + (text.starts_with('+') ? 1 : 0), *to = text.data() + text.size();
  double value = 0.0;
  std::string_view rest(from, static_cast<std::size_t>(to - from));
  rest.remove_prefix(static_cast<std::size_t>(std::from_chars(from, to, value).ptr - from));
  while (rest.starts_with(' ')) rest.remove_prefix(1);
  while (rest.ends_with(' ')) rest.remove_suffix(1);
  return std::string(rest);
}

bool is_unit(std::string_view text) { return std::holds_alternative<Size>(size_of(text)); }

std::variant<double, std::string> quantity_in(const std::string& text, const std::string& unit) {
  const char *from = text.data() + (text.starts_with('+') ? 1 : 0), *to = text.data() + text.size();
  double value = 0.0;
  const auto [end, error] = std::from_chars(from, to, value);
  if (error != std::errc()) return std::string("it does not begin with a number");
  std::string_view rest(end, static_cast<std::size_t>(to - end));
  while (rest.starts_with(' ')) rest.remove_prefix(1);
  while (rest.ends_with(' ')) rest.remove_suffix(1);
  if (rest.empty())
    return unit.empty() ? std::string()
                        : fmt::format("it has no unit, write \"{} {}\"", text, unit);
  const auto given = size_of(rest), wanted = size_of(unit);
  if (const auto* why = std::get_if<std::string>(&given)) return *why;
  const Size &has = std::get<Size>(given), &asked = std::get<Size>(wanted);
  if (has.powers != asked.powers)
    return unit.empty() ? fmt::format("it is a pure number and has no {}", rest)
                        : fmt::format("{} is not a unit of what is measured in {}", rest, unit);
  return scaled(std::string(from, end), value, has.factor / asked.factor);
}

}  // namespace graze
