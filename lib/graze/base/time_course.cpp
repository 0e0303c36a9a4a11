#include "graze/base/time_course.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace graze {

TimeCourse::TimeCourse(std::vector<double> given_times, std::vector<double> given_values,
                       bool does_repeat)
    : times(std::move(given_times)), values(std::move(given_values)), repeats(does_repeat) {
  for (const double value : values) largest = std::max(largest, std::abs(value));
  for (std::size_t k = 1; k < times.size(); ++k)
    steepest =
        std::max(steepest, std::abs(values[k] - values[k - 1]) / (times[k] - times[k - 1]));
}

TimeCourse::Place TimeCourse::place_of(double t) const {
  const double length = times.back() - times.front();
  // An instant at which a flight was cut is known to so many roundings.
  const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * std::abs(t);
  double turned = 0.0;
  if (repeats) turned = length * std::floor((t + rounding - times.front()) / length);
  const double folded = t - turned;
  const auto end = std::upper_bound(times.begin(), times.end(), folded + rounding);
  return {static_cast<std::size_t>(end - times.begin()), folded, turned};
}

double TimeCourse::at(double t) const {
  const auto [end, folded, turned] = place_of(t);
  if (end == 0 || end == times.size()) return 0.0;
  const double part = (folded - times[end - 1]) / (times[end] - times[end - 1]);
  return values[end - 1] + part * (values[end] - values[end - 1]);
}

double TimeCourse::slope(double t) const {
  const std::size_t end = place_of(t).end;
  if (end == 0 || end == times.size()) return 0.0;
  return (values[end] - values[end - 1]) / (times[end] - times[end - 1]);
}

double TimeCourse::next(double t) const {
  const auto [end, folded, turned] = place_of(t);
  return end < times.size() ? times[end] + turned : std::numeric_limits<double>::infinity();
}

}  // namespace graze
