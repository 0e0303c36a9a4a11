// What changes over time along straight lines between instants, as a measured load does.
#pragma once

#include <vector>

namespace graze {

// Zero before the first instant and behind the last; or `repeats` from the last on, which then is the
// first again.
struct TimeCourse {
  TimeCourse(std::vector<double> times, std::vector<double> values, bool repeats);

  std::vector<double> times;   // s, rising, at least two
  std::vector<double> values;  // as many
  bool repeats = false;
  double largest = 0.0;   // |value|
  double steepest = 0.0;  // |slope|, 1/s

  // On the line that begins at an instant, where t is within rounding of it.
  double at(double t) const;
  double slope(double t) const;  // 1/s
  // The next instant behind t at which another line begins; infinite where there is none.
  double next(double t) const;

 private:
  // The line at t: the place of the instant that ends it, 0 and times.size() outside; and t folded
  // into the first turn of what repeats.
  struct Place {
    std::size_t end;
    double t;
    double turned;  // by which t was folded
  };
  Place place_of(double t) const;
};

}  // namespace graze
