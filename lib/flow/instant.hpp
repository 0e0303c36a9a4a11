// A point in time, kept so that long runs lose no digits: whole forcing periods are counted, and
// only the rest is a real number. Without forcing the period is infinite and `local` is the time.
#pragma once

namespace graze {

template <class Real>
struct Instant {
  long long period = 0;  // whole forcing periods since t = 0
  Real local = 0;        // s since the start of that period, in [0, T)
};

}  // namespace graze
