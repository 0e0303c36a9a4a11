// The forces of stops over time, against closed forms of their impulses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "graze/motion/simulation.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using std::numbers::pi;

Amplitudes measured(const System& system, const State& start, double seconds, int count,
                    double from = 0.0) {
  SimulationOptions options = support::for_seconds(seconds);
  options.measure = MeasureOptions{{}, from, ForceWindows{(seconds - from) / count, count}};
  return *simulate(system, start, options).amplitudes;
}

// A ball of 2 kg dropped from 5 m at g = 10 m/s^2 leaves with half of its 10 m/s: it falls for 1 s
// and is back after 1 s more.
TEST(ImpulseWindows, HoldTheImpulseOfEachImpact) {
  const double root = std::sqrt(2.0);
  System system = support::oscillator(0.0, 0.0, 5.0, 0.5);
  system.stops[0].row[0] = 1.0 / root;
  system.stops[0].impact().direction[0] = root;
  system.modal().load = Vector::Constant(1, root * 10.0);
  const Amplitudes found = measured(system, support::rest(system), 2.25, 9);
  ASSERT_TRUE(found.forces.has_value());
  EXPECT_EQ(found.forces->length, 0.25);
  const std::vector<double>& means = found.forces->means[0];
  ASSERT_EQ(means.size(), 9u);
  for (std::size_t k = 0; k < means.size(); ++k) {
    // Impacts lie on the ends of windows, up to rounding: a pair holds either.
    if (k % 4 == 3 || (k % 4 == 0 && k > 0)) continue;
    EXPECT_EQ(means[k], 0.0) << k;
  }
  EXPECT_NEAR(0.25 * (means[3] + means[4]), 2.0 * 15.0, 1e-12);
  EXPECT_NEAR(0.25 * (means[7] + means[8]), 2.0 * 7.5, 1e-12);
  EXPECT_EQ(found.stops[0].held, 0.0);
  // From later on, and with the impact within a window.
  const Amplitudes late = measured(system, support::rest(system), 2.25, 3, 1.05);
  EXPECT_EQ(late.forces->from, 1.05);
  EXPECT_EQ(late.forces->means[0][0], 0.0);
  EXPECT_EQ(late.forces->means[0][1], 0.0);
  EXPECT_NEAR(late.forces->means[0][2], 2.0 * 7.5 / 0.4, 1e-12);
}

// Held by a stop below its rest, the force is w^2 |gap| plus that of the forcing.
TEST(ImpulseWindows, HoldTheForceOfAClosedStop) {
  const System system = support::forced_oscillator(2.0, 0.1, -0.5, 0.3, 1.5, 1.2);
  State start = support::rest(system);
  start.q[0] = -0.5;
  const double end = 3.0;
  const Amplitudes found = measured(system, start, end, 7);
  const std::vector<double>& means = found.forces->means[0];
  ASSERT_EQ(means.size(), 7u);
  for (std::size_t k = 0; k < 7; ++k) {
    const double a = end / 7.0 * static_cast<double>(k), b = a + end / 7.0;
    const double exact = 4.0 * 0.5 + 1.2 / 1.5 * (std::sin(1.5 * b) - std::sin(1.5 * a)) / (b - a);
    EXPECT_NEAR(means[k], exact, 1e-12) << k;
  }
  EXPECT_NEAR(found.stops[0].held, end, 1e-14);
}

// A mass of 1 kg meets a spring of 100 N/m at 3 m/s after 0.5 m: the force is 30 sin(10 t).
TEST(ImpulseWindows, HoldTheForceOfASpring) {
  System system = support::oscillator(0.0, 0.0, 0.5, 0.0);
  ContactForce law;
  law.stiffness = 100.0;
  law.exponent = 1.0;
  system.stops[0].law = law;
  const double there = 0.5 / 3.0, end = 0.6;
  const Amplitudes found = measured(system, support::state_of({0.0}, {3.0}), end, 11);
  const auto impulse = [&](double t) {
    return 3.0 * (1.0 - std::cos(std::clamp(10.0 * (t - there), 0.0, pi)));
  };
  for (std::size_t k = 0; k < 11; ++k) {
    const double a = end / 11.0 * static_cast<double>(k), b = a + end / 11.0;
    EXPECT_NEAR(found.forces->means[0][k], (impulse(b) - impulse(a)) / (b - a), 1e-10) << k;
  }
  EXPECT_EQ(found.stops[0].held, 0.0);
}

// A run that is cut by its budget has the windows that it filled, none of them in part.
TEST(ImpulseWindows, EndWithTheRun) {
  const System system = support::oscillator(1.0, 0.0, 0.0, 1.0);
  SimulationOptions options = support::for_seconds(20.0);
  options.max_impacts = 2;
  options.measure = MeasureOptions{{}, 0.0, ForceWindows{0.5, 40}};
  const Simulation run = simulate(system, support::state_of({0.0}, {-1.0}), options);
  // The second impact is at 2 pi.
  ASSERT_EQ(run.outcome, RunOutcome::kEventBudget);
  EXPECT_EQ(run.amplitudes->forces->means[0].size(), 12u);
}

}  // namespace
}  // namespace graze
