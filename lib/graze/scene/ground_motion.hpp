// A clamp or a ground that moves as a record says.
#pragma once

#include <vector>

#include "graze/base/time_course.hpp"

namespace graze {

// Second derivatives at the instants of the cubic spline through these values, which joins them
// with the least bending; they are joined by straight lines themselves. Zero at both ends; or of a
// motion that repeats, whose last value is the first one. At least two instants, rising.
std::vector<double> spline_accelerations(const std::vector<double>& times,
                                         const std::vector<double>& values, bool repeats);

// Where a clamp is that starts at rest and is accelerated so once, at the last instant: what the
// record is away from bringing it back.
struct Drift {
  double displacement, velocity;  // m, m/s
};
Drift drift_of(const TimeCourse& acceleration);

}  // namespace graze
