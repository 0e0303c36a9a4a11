#include "graze/orbit/problem/detail/orbit_clock.hpp"

#include <cmath>

#include "graze/base/angle.hpp"

namespace graze {

OrbitClock::OrbitClock(const System& system, int period,
                       const std::vector<Instant<double>>& impacts)
    : forcing_(*system.forcing()), period_(period) {
  const Instant<double>* first = nullptr;
  double smallest = 0.0;
  for (const Instant<double>& at : impacts) {
    const double phase = wrapped(theta(at));
    if (first && !(phase < smallest)) continue;
    first = &at;
    smallest = phase;
  }
  if (first) origin_ = turns(*first);
}

OrbitInstant OrbitClock::operator()(const Instant<double>& at) const {
  const long long index = (turns(at) - origin_) % period_;
  return {static_cast<int>(index < 0 ? index + period_ : index), wrapped(theta(at))};
}

double OrbitClock::theta(const Instant<double>& at) const {
  return forcing_.frequency * at.local + forcing_.phase;
}

long long OrbitClock::turns(const Instant<double>& at) const {
  return at.period + std::llround((theta(at) - wrapped(theta(at))) / kTurn);
}

bool earlier(const OrbitInstant& a, const OrbitInstant& b) {
  return a.period_index != b.period_index ? a.period_index < b.period_index : a.phase < b.phase;
}

}  // namespace graze
