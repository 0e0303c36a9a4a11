#include "graze/base/time_course.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {

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

double TimeCourse::largest() const {
  double most = 0.0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

double TimeCourse::steepest() const {
  double most = 0.0;
  for (std::size_t k = 1; k < times.size(); ++k)
    most = std::max(most, std::abs(values[k] - values[k - 1]) / (times[k] - times[k - 1]));
  return most;
}

}  // namespace graze
