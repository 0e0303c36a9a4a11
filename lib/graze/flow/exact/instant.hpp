// A point in time, kept so that long runs lose no digits: whole forcing periods are counted, and
// only the rest is a real number. Without forcing the period is infinite and `local` is the time.
#pragma once

#include <algorithm>
#include <cmath>

namespace graze {

template <class Real>
struct Instant {
  long long period = 0;  // whole forcing periods since t = 0
  Real local = 0;        // s since the start of that period, in [0, T)
};

// Compares instants of any two scalar types.
template <class A, class B>
bool not_before(const Instant<A>& a, const Instant<B>& b) {
  return a.period > b.period || (a.period == b.period && a.local >= b.local);
}

// Time since t = 0, s.
template <class Real>
Real seconds_at(const Instant<Real>& instant, const Real& period) {
  return instant.period == 0 ? instant.local
                             : Real(static_cast<Real>(instant.period) * period + instant.local);
}

// The instant `seconds` >= 0 later, for forcing periods of `period` seconds.
template <class Real>
Instant<Real> later(const Instant<Real>& from, const Real& seconds, const Real& period) {
  using std::floor;
  Instant<Real> at = from;
  at.local += seconds;
  const Real periods = floor(at.local / period);  // 0 if infinite
  if (periods > 0) {
    at.local = std::max<Real>(at.local - periods * period, 0);
    at.period += static_cast<long long>(periods);
  }
  return at;
}

}  // namespace graze
