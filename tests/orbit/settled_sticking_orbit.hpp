// Orbits that stick, found as the motion of a scene settles on them, and their simulated map.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/angle.hpp"
#include "graze/orbit/problem/detail/followed_orbit.hpp"
#include "graze/orbit/search/settled.hpp"
#include "support/differences.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {

struct Found {
  System system;
  Orbit orbit;
};

// The orbit that the motion of a scene settles on.
inline Found settled_orbit(const Scene& scene, std::optional<double> closure_speed = {}) {
  Found found{assemble(scene), {}};
  const State start = initial_state(scene, found.system);
  const double speed = closure_speed.value_or(default_closure_speed(found.system, start));
  SettleOptions options;
  options.closure_speed = speed;
  const SettledMotion settled = settle(found.system, start, options);
  EXPECT_EQ(settled.kind, SettledKind::kSticks) << settled.classification;
  const FollowedAnswer answer =
      followed_orbit(found.system, settled.at_start, settled.period, {speed, 10'000'000, {}});
  EXPECT_TRUE(answer.orbit) << answer.why_not;
  if (answer.orbit) found.orbit = *answer.orbit;
  return found;
}

inline Scene sticking_case(const std::string& name, const std::vector<std::string>& settings = {}) {
  return support::reference_scene("sticking/" + name, settings);
}

// The beam of the reference cases, softened until its motion repeats.
inline Scene beam(const char* law, int modes, double frequency) {
  return sticking_case("beam2", {"beam.modes=" + std::to_string(modes),
                                 "forcing.frequency=" + std::to_string(frequency),
                                 "stop.impulse=\"" + std::string(law) + "\"",
                                 "stop.restitution=0.2", "damping.viscous=0.05"});
}

inline int exact_zeros(const Orbit& orbit) {
  return static_cast<int>(
      std::count_if(orbit.multipliers.begin(), orbit.multipliers.end(),
                    [](const Eigenvalue& m) { return m.value == Complex(0.0) && m.error == 0.0; }));
}

inline double turned(double a, double b) { return std::abs(std::remainder(a - b, kTurn)); }

// The simulated map over the orbit's periods from its section, by a run.
inline State simulated(const Found& found, const State& start) {
  const OrbitSection& section = *found.orbit.section;
  RunState from;
  from.motion = section.states.front();
  from.motion.q = start.q;
  from.motion.qdot = start.qdot;
  from.streaks.resize(found.system.stops.size());
  from.closure_speed = section.closure_speed;
  from.started = true;
  SimulationOptions options;
  options.duration =
      section.states.front().instant.local + found.orbit.period * found.system.period();
  return resume(found.system, from, options).final;
}

inline std::vector<int> closed_at_section(const Orbit& orbit) {
  std::vector<int> closed;
  const auto& contacts = orbit.section->states.front().contacts;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (contacts[i] == Contact::kClosed) closed.push_back(static_cast<int>(i));
  return closed;
}

// Eigenvalues of the map on the held motion's coordinates, by central differences.
inline std::vector<Eigenvalue> differenced_multipliers(const Found& found) {
  const ConstrainedStructure<double> held(found.system, closed_at_section(found.orbit));
  const Matrix basis = held.basis;
  const Eigen::Index m = basis.cols();
  const MotionScale scale = motion_scale(found.system);
  const MotionState<double>& at = found.orbit.section->states.front();
  Vector unit(2 * m);
  unit << Vector::Constant(m, scale.displacement),
      scale.displacement * held.reduced.omega.cwiseMax(found.system.forcing()->frequency);
  const auto map = [&](const Vector& z) {
    const Vector x = z.cwiseProduct(unit);
    const State end = simulated(found, {at.q + basis * x.head(m), at.qdot + basis * x.tail(m)});
    Vector y(2 * m);
    y << basis.transpose() * (end.q - at.q), basis.transpose() * (end.qdot - at.qdot);
    return Vector(y.cwiseQuotient(unit));
  };
  return eigenvalues(
      support::central_jacobian(map, Vector::Zero(2 * m), Vector::Constant(2 * m, 1e-4)));
}

}  // namespace graze
