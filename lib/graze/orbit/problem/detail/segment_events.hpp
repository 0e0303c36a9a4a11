// The events of segments from section to section as those of one orbit: contacts and stuck phases
// that a section cuts are joined again.
#pragma once

#include <optional>
#include <vector>

#include "graze/flow/exact/instant.hpp"
#include "graze/orbit/problem/detail/grazing_contact.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {

// A grazing contact, where an orbit has one.
struct MetGrazing {
  GrazingContact grazing;
  Instant<double> at;  // counted within its segment
  State state;
};

// Adds the impacts and the stuck phases to the orbit, in time order, and sets the instant of the
// first of its section's states. `periods`: of each segment.
void add_events(const System& system, const std::vector<TrajectorySegment>& segments, int periods,
                const std::optional<MetGrazing>& grazing, Orbit& orbit);

// Places instants within an orbit, counted from the impact of the smallest phase.
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
