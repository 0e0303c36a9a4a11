// The slope of a function that is known at solutions beside a place, without derivatives of its
// own.
#pragma once

#include <optional>
#include <utility>

namespace graze {

// Of value(s) at s = 0 from s = -2 h .. 2 h; value: double -> optional<double>. The error is of the
// fourth power of h. Returns nullopt where one of them is not known.
template <class Value>
std::optional<double> slope_at_zero(double h, const Value& value) {
  double change = 0.0;
  for (const auto& [steps, weight] : {std::pair(1.0, 8.0), std::pair(2.0, -1.0)})
    for (const double side : {1.0, -1.0}) {
      const std::optional<double> there = value(side * steps * h);
      if (!there) return {};
      change += side * weight * *there;
    }
  return change / (12.0 * h);
}

}  // namespace graze
