// Places instants within an orbit, counted from the impact of the smallest phase.
#pragma once

#include <vector>

#include "graze/flow/exact/instant.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {

class OrbitClock {
 public:
  // `impacts`: of one period of the orbit. Requires forcing; refers to the system.
  OrbitClock(const System& system, int period, const std::vector<Instant<double>>& impacts);

  OrbitInstant operator()(const Instant<double>& at) const;

 private:
  double theta(const Instant<double>& at) const;
  long long turns(const Instant<double>& at) const;

  const HarmonicForcing& forcing_;
  const int period_;
  long long origin_ = 0;
};

// Whether a comes before b within the orbit.
bool earlier(const OrbitInstant& a, const OrbitInstant& b);

}  // namespace graze
