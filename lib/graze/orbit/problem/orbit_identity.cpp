#include "graze/orbit/problem/orbit_identity.hpp"

#include <algorithm>
#include <cmath>

#include "graze/base/angle.hpp"

namespace graze {
namespace {

double phase_distance(double a, double b) { return std::abs(std::remainder(a - b, kTurn)); }

bool same_impact(const OrbitImpact& a, const OrbitImpact& b, double largest_speed) {
  return a.stop == b.stop && phase_distance(a.phase, b.phase) <= kSameOrbit &&
         std::abs(a.speed - b.speed) <= kSameOrbit * largest_speed;
}

double turned(const OrbitImpact& impact) { return impact.phase + kTurn * impact.period_index; }

// Whether the forcing phase between two impacts is the same on both orbits.
bool same_lapse(const Orbit& orbit, const OrbitImpact& x, const OrbitImpact& x_first,
                const OrbitImpact& y, const OrbitImpact& y_first) {
  const double lapse = turned(x) - turned(x_first) - (turned(y) - turned(y_first));
  return std::abs(std::remainder(lapse, kTurn * orbit.period)) <= 2.0 * kSameOrbit;
}

// Orbits without impacts are told apart by their states on the section.
bool same_states(const Orbit& a, const Orbit& b) {
  if (!a.section || !b.section || a.section->states.size() != b.section->states.size())
    return a.impacts.empty() && b.impacts.empty();
  const auto same = [](const Vector& x, const Vector& y) {
    return (x - y).norm() <= kSameOrbit * (x.norm() + y.norm());
  };
  const std::size_t count = a.section->states.size();
  for (std::size_t turn = 0; turn < count; ++turn) {
    bool all = true;
    for (std::size_t i = 0; i < count && all; ++i) {
      const MotionState<double>&x = a.section->states[i],
            &y = b.section->states[(i + turn) % count];
      all = same(x.q, y.q) && same(x.qdot, y.qdot);
    }
    if (all) return true;
  }
  return false;
}

// -1, 0 or 1 as one of their numbers orders a before b, all tie, or b comes before a.
template <class Number>
int compare(const Orbit& a, const Orbit& b, Number OrbitImpact::*number) {
  for (std::size_t i = 0; i < a.impacts.size(); ++i) {
    const Number x = a.impacts[i].*number, y = b.impacts[i].*number;
    if (x < y) return -1;
    if (y < x) return 1;
  }
  return 0;
}

}  // namespace

bool same_orbit(const Orbit& a, const Orbit& b, double speed_scale) {
  if (a.period != b.period || a.impacts.size() != b.impacts.size() || a.sticks() != b.sticks())
    return false;
  if (a.impacts.empty()) return same_states(a, b);
  double largest = speed_scale;
  for (const OrbitImpact& impact : a.impacts) largest = std::max(largest, std::abs(impact.speed));
  // Two impacts of nearly one phase may have been ordered either way: try every rotation.
  for (std::size_t turn = 0; turn < b.impacts.size(); ++turn) {
    bool same = true;
    for (std::size_t i = 0; i < a.impacts.size() && same; ++i) {
      const OrbitImpact& x = a.impacts[i];
      const OrbitImpact& y = b.impacts[(i + turn) % b.impacts.size()];
      same = same_impact(x, y, largest) && same_lapse(a, x, a.impacts[0], y, b.impacts[turn]);
    }
    if (same) return true;
  }
  return false;
}

std::optional<ImpactPattern> repeated_pattern(const Orbit& orbit) {
  const int k = static_cast<int>(orbit.impacts.size());
  double largest = 0.0;
  for (const OrbitImpact& impact : orbit.impacts)
    largest = std::max(largest, std::abs(impact.speed));
  for (int parts = k; parts > 1; --parts) {
    if (k % parts != 0 || orbit.period % parts != 0) continue;
    const int p = orbit.period / parts, n = k / parts;
    bool repeats = true;
    for (int i = n; i < k && repeats; ++i) {
      const OrbitImpact& a = orbit.impacts[static_cast<std::size_t>(i - n)];
      const OrbitImpact& b = orbit.impacts[static_cast<std::size_t>(i)];
      repeats = same_impact(a, b, largest);
    }
    if (!repeats) continue;
    ImpactPattern pattern{p, orbit.pattern().stops};
    pattern.stops.resize(static_cast<std::size_t>(n));
    return pattern;
  }
  return {};
}

bool comes_before(const Orbit& a, const Orbit& b) {
  if (a.period != b.period) return a.period < b.period;
  if (a.impacts.size() != b.impacts.size()) return a.impacts.size() < b.impacts.size();
  if (const int order = compare(a, b, &OrbitImpact::phase)) return order < 0;
  if (const int order = compare(a, b, &OrbitImpact::stop)) return order < 0;
  if (const int order = compare(a, b, &OrbitImpact::period_index)) return order < 0;
  return compare(a, b, &OrbitImpact::speed) < 0;
}

}  // namespace graze
