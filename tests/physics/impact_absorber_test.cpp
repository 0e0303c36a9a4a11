// The shipped impact absorber against a closed form: the motion with two impacts per period that
// repeats with the other sign after half a period, after S. F. Masri and T. K. Caughey, On the
// stability of the impact damper, J. Appl. Mech. 33 (1966) 586, derived here anew.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "graze/assembly/assembly.hpp"
#include "graze/orbit/search/finder.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

constexpr double kPi = 3.141592653589793;

// The numbers of data/scenes/25_impact_absorber.toml and its matrices.
constexpr double kMass = 4.0, kBody = 0.06;         // M, m, kg
constexpr double kStiffness = 1e4, kDashpot = 4.0;  // K, N/m, and C = 4e-4 s K, N s/m
constexpr double kForce = 2.0;                      // F, N
constexpr double kGap = 8e-3, kRestitution = 0.6;   // g, m; r
constexpr double kReduced = kMass * kBody / (kMass + kBody);

struct SymmetricOrbit {
  double phase = 0.0;      // of the impact on the far end, rad, 0..2 pi
  double speed = 0.0;      // of approach, m/s
  Eigen::Vector2d before;  // place and velocity of the mass just before it
};

// State (X, X') of M X'' + C X' + K X = 0 after a time.
Eigen::Matrix2d free_motion(double time) {
  const double delta = kDashpot / (2.0 * kMass), square = kStiffness / kMass;
  const double w = std::sqrt(square - delta * delta);
  const double c = std::cos(w * time), s = std::sin(w * time) / w;
  Eigen::Matrix2d e;
  e << c + delta * s, s, -square * s, c - delta * s;
  return std::exp(-delta * time) * e;
}

// At time 0 the body meets the far end, y - X = g, and leaves it with the velocity v. It flies
// freely and all is repeated with the other sign after T/2, hence y(0) = -v T/4, X(0) = -g - v T/4,
// and its velocity before the impact is -v. Momentum and restitution give the mass
//   V- = v (1 - r + 2 m/M)/(1 + r)   and   V+ = V- - 2 v m/M.
// The free part h of X has h(T/2) = -h(0), h'(T/2) = -h'(0) + V+ - V-, the forced one
// p = Re(H F e^(i phase)), H = 1/(K - M W^2 + i C W), at time 0. All are linear in v, and
// p^2 + (p'/W)^2 = |H F|^2 is a quadratic equation for it.
std::vector<SymmetricOrbit> symmetric_orbits(double frequency) {
  const double half = kPi / frequency, ratio = kBody / kMass;
  const double before = (1.0 - kRestitution + 2.0 * ratio) / (1.0 + kRestitution);
  const double after = before - 2.0 * ratio;
  const Eigen::Vector2d free = (free_motion(half) + Eigen::Matrix2d::Identity()).inverse() *
                               Eigen::Vector2d(0.0, -2.0 * ratio);
  // p = a v - g, p'/W = b v.
  const double a = -half / 2.0 - free[0], b = (after - free[1]) / frequency;
  const std::complex<double> response =
      kForce /
      std::complex<double>(kStiffness - kMass * frequency * frequency, kDashpot * frequency);
  const double leading = a * a + b * b;
  const double root = a * a * kGap * kGap - leading * (kGap * kGap - std::norm(response));
  std::vector<SymmetricOrbit> orbits;
  if (root < 0.0) return orbits;
  for (const double sign : {-1.0, 1.0}) {
    const double v = (a * kGap + sign * std::sqrt(root)) / leading;
    SymmetricOrbit orbit;
    // Towards the far end, relative to the mass.
    orbit.speed = -v - before * v;
    if (orbit.speed <= 0.0) continue;
    const std::complex<double> forced(a * v - kGap, -b * v);
    const double angle = std::arg(forced / response);
    orbit.phase = angle < 0.0 ? angle + 2.0 * kPi : angle;
    orbit.before = {-kGap - half * v / 2.0, before * v};
    orbits.push_back(orbit);
  }
  return orbits;
}

Scene absorber(double frequency) {
  Scene scene = support::shipped_scene("25_impact_absorber");
  scene.forcing->frequency = frequency;
  return scene;
}

FoundOrbits found_orbits(double frequency) {
  FinderOptions options;
  options.impacts = 2;
  options.from_simulation = false;
  return find_orbits(assemble(absorber(frequency)), {}, options);
}

void expect_symmetric(const Orbit& orbit, const std::vector<SymmetricOrbit>& exact) {
  ASSERT_EQ(orbit.impacts.size(), 2u);
  const auto far = std::find_if(orbit.impacts.begin(), orbit.impacts.end(),
                                [](const OrbitImpact& impact) { return impact.stop == 0; });
  ASSERT_NE(far, orbit.impacts.end());
  EXPECT_NEAR(orbit.impacts[1].phase - orbit.impacts[0].phase, kPi, 1e-10);
  EXPECT_NEAR(orbit.impacts[1].speed, orbit.impacts[0].speed, 1e-10 * far->speed);
  const auto same = std::find_if(exact.begin(), exact.end(), [&](const SymmetricOrbit& other) {
    return std::abs(other.phase - far->phase) < 0.1;
  });
  ASSERT_NE(same, exact.end()) << far->phase;
  EXPECT_NEAR(far->phase, same->phase, 1e-10);
  EXPECT_NEAR(far->speed, same->speed, 1e-10 * same->speed);
  // The mass is mode 2 alone.
  const double shape = 1.0 / std::sqrt(kMass);
  EXPECT_NEAR(shape * far->before.q[1], same->before[0], 1e-10 * kGap);
  EXPECT_NEAR(shape * far->before.qdot[1], same->before[1], 1e-10 * same->speed);
}

TEST(ImpactAbsorber, HasTheSymmetricOrbitOfTheClosedForm) {
  for (const double frequency : {50.0, 50.5, 51.0, 52.0}) {
    SCOPED_TRACE(frequency);
    const std::vector<SymmetricOrbit> exact = symmetric_orbits(frequency);
    ASSERT_FALSE(exact.empty());
    const FoundOrbits found = found_orbits(frequency);
    EXPECT_EQ(found.orbits.size(), exact.size());
    for (const Orbit& orbit : found.orbits) expect_symmetric(orbit, exact);
  }
}

// What the stops give the body is its momentum, and an impact takes the part 1 - r^2 of the energy
// of the relative motion.
TEST(ImpactAbsorber, KeepsMomentumAtItsImpacts) {
  const System system = assemble(absorber(50.0));
  const support::RecordedRun run =
      support::record_run(system, support::rest(system), support::for_periods(100));
  ASSERT_GE(run.events.size(), 50u);
  double momentum = 0.0, passed = 0.0;
  for (const Event& event : run.events) {
    ASSERT_EQ(event.kind, EventKind::kImpact);
    const double impulse = kReduced * (1.0 + kRestitution) * event.speed;
    momentum += event.stop == 0 ? -impulse : impulse;
    passed += impulse;
    const double lost =
        0.5 * kReduced * (1.0 - kRestitution * kRestitution) * event.speed * event.speed;
    EXPECT_NEAR(event.energy_change, -lost, 1e-12 * lost);
  }
  // The body is mode 1 alone.
  const double velocity = run.result.final.qdot[0] / std::sqrt(kBody);
  EXPECT_NEAR(kBody * velocity, momentum, 1e-12 * passed);
}

}  // namespace
}  // namespace graze
