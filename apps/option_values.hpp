// What the value of an option may be, each with the sentence that refuses any other.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "graze/record/names/detail/sweep_names.hpp"
#include "graze/scene/detail/value_checker.hpp"

namespace graze {

// A finite number that fits; `what` names those that do.
template <class Fits>
CLI::Validator number(const std::string& what, const Fits& fits) {
  return CLI::Validator(
      [what, fits](std::string& text) {
        double value = 0.0;
        const bool good =
            CLI::detail::lexical_cast(text, value) && std::isfinite(value) && fits(value);
        return good ? std::string() : fmt::format("'{}' is not {}", text, what);
      },
      "");
}

// Of a size that scenes allow too.
inline CLI::Validator finite_number() {
  return CLI::Validator(
      [](std::string& text) {
        double value = 0.0;
        if (!CLI::detail::lexical_cast(text, value) || !std::isfinite(value))
          return fmt::format("'{}' is not a finite number", text);
        return std::abs(value) <= kLargestNumber
                   ? std::string()
                   : fmt::format("'{}' is not a number of at most {:.1e} in size", text,
                                 kLargestNumber);
      },
      "");
}

inline CLI::Validator above_zero() {
  return number("a number above 0", [](double value) { return value > 0.0; });
}

inline CLI::Validator at_least(const std::string& what, double least) {
  return number(what, [least](double value) { return value >= least; });
}

// A whole number; 1e3 for 1000 is one too, and then written out.
inline CLI::Validator whole_number(const std::string& what, double least, double most) {
  return CLI::Validator(
      [what, least, most](std::string& text) {
        double value = 0.0;
        if (!CLI::detail::lexical_cast(text, value) || !(value >= least && value <= most) ||
            value != std::floor(value))
          return fmt::format("'{}' is not {}", text, what);
        if (text.find_first_of(".eE") != std::string::npos) text = fmt::format("{:.0f}", value);
        return std::string();
      },
      "");
}

inline CLI::Validator whole_number_within(int least, int most) {
  return whole_number(fmt::format("a whole number from {} to {}", least, most), least, most);
}

// The words of things that have a name_of, and what makes a word the thing.
template <class List>
std::vector<std::string> names_of(const List& things) {
  std::vector<std::string> names;
  for (const auto& thing : things) names.push_back(name_of(thing));
  return names;
}
template <class Value, class List>
std::function<void(const std::string&)> set_by_name(Value& value, const List& things) {
  return [&value, &things](const std::string& word) {
    for (const auto& thing : things)
      if (name_of(thing) == word) value = thing;
  };
}

// An option that takes one of them.
template <class Value, class List>
CLI::Option* add_choice(CLI::App* app, const char* name, Value& value, const List& things,
                        const char* what) {
  return app->add_option_function<std::string>(name, set_by_name(value, things), what)
      ->check(CLI::IsMember(names_of(things)))
      ->default_str(name_of(value));
}

// Of two words, whether it is the second.
inline std::function<void(const std::string&)> set_if(bool& value, const char* second) {
  return [&value, second](const std::string& word) { value = word == second; };
}

// What --section may say. "strobe" is what stroboscopic was called before 0.1.0.
inline CLI::Validator section_name() {
  const CLI::Validator known = CLI::IsMember(names_of(kDiagramSections));
  return CLI::Validator(
      [known](std::string& text) {
        if (text == "strobe") text = "stroboscopic";
        return known(text);
      },
      known.get_description());
}

// Beyond the cores of any machine, and short of what a process may start.
inline constexpr double kMostThreads = 1024.0;
// What the counts can hold.
inline constexpr double kMostPeriods = 0x1p30;
inline constexpr double kMostCounted = 0x1p62;

}  // namespace graze
