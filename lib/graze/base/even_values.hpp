// Values at equal distances, both ends exactly.
#pragma once

#include <vector>

namespace graze {

// The i-th of `points` >= 2 values from `from` to `to`, both among them.
inline double even_value(double from, double to, int i, int points) {
  const double part = static_cast<double>(i) / static_cast<double>(points - 1);
  return i + 1 == points ? to : from + part * (to - from);
}

// All of these values.
inline std::vector<double> even_values(double from, double to, int points) {
  std::vector<double> values;
  for (int i = 0; i < points; ++i) values.push_back(even_value(from, to, i, points));
  return values;
}

}  // namespace graze
