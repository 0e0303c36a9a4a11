// How large motions are, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "graze/motion/simulation.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using std::numbers::pi;

MeasureOptions at_first_mode(const System& system, double from = 0.0) {
  Vector row = Vector::Zero(system.modes());
  row[0] = 1.0;
  return {{{row, false}, {row, true}}, from};
}

Amplitudes measured(const System& system, const State& start, SimulationOptions options,
                    double from = 0.0) {
  options.measure = at_first_mode(system, from);
  return *simulate(system, start, options).amplitudes;
}

System without_stops(System system) {
  system.stops.clear();
  return system;
}

TEST(Amplitudes, OfTheResponseAreThoseOfTheTransferFunction) {
  for (const double frequency : {0.3, 0.97, 2.5}) {
    const System system =
        without_stops(support::forced_oscillator(1.0, 0.02, 1.0, 0.5, frequency, 0.7));
    const Complex p = 0.7 / Complex(1.0 - frequency * frequency, 2.0 * 0.02 * frequency);
    const State start = support::state_of({p.real()}, {(Complex(0.0, frequency) * p).real()});
    const Amplitudes found = measured(system, start, support::for_periods(3));
    const double size = std::abs(p);
    const Amplitude& u = found.rows[0];
    EXPECT_NEAR(u.highest, size, 1e-13 * size);
    EXPECT_NEAR(u.lowest, -size, 1e-13 * size);
    EXPECT_NEAR(u.mean, 0.0, 1e-13 * size);
    EXPECT_NEAR(u.rms, size / std::sqrt(2.0), 1e-13 * size);
    EXPECT_NEAR(std::abs(*u.harmonic - p), 0.0, 1e-12 * size);
    EXPECT_NEAR(*u.speed, frequency * size, 1e-13 * size);
    EXPECT_NEAR(found.rows[1].highest, frequency * size, 1e-13 * size);
    EXPECT_NEAR(found.rows[1].rms, frequency * size / std::sqrt(2.0), 1e-13 * size);
    EXPECT_FALSE(found.rows[1].speed.has_value());
    EXPECT_NEAR(found.duration, 3.0 * 2.0 * pi / frequency, 1e-12);
  }
}

// From rest, where no gap tells how far it goes and no exponentials are written.
TEST(Amplitudes, OfMotionFromRestAtResonance) {
  const System system = without_stops(support::forced_oscillator(1.0, 0.0, 1.0, 0.5, 1.0, 2.0));
  // u = t sin t: |u| is largest at the end of a period where tan t = -t, and its square sums to
  // T^3/6 - T/4 over periods T.
  const Amplitudes found = measured(system, support::rest(system), support::for_periods(2));
  const double t = 4.0 * pi;
  double peak = 3.5 * pi;
  for (int i = 0; i < 50; ++i) peak = 4.0 * pi - std::atan(peak);
  EXPECT_NEAR(found.rows[0].lowest, peak * std::sin(peak), 1e-12);
  EXPECT_NEAR(found.rows[0].rms, std::sqrt((t * t * t / 6.0 - t / 4.0) / t), 1e-12);
  EXPECT_NEAR(found.rows[0].mean, -1.0, 1e-13);
}

// A ball of mass 2 dropped from 5 m: u = g t^2/2, a bounce at 10 m/s, half of it left, and up to
// the top of that.
TEST(Amplitudes, OfAFallAndABounce) {
  const double root = std::sqrt(2.0), g = 10.0;
  System system = support::oscillator(0.0, 0.0, 5.0, 0.5);
  system.stops[0].row[0] = 1.0 / root;
  system.stops[0].impact().direction[0] = root;
  system.modal().load = Vector::Constant(1, root * g);
  SimulationOptions options = support::for_seconds(1.5);
  options.measure = MeasureOptions{{{system.stops[0].row, false}}, 0.0};
  const Amplitudes found = *simulate(system, support::rest(system), options).amplitudes;
  const Amplitude& u = found.rows[0];
  EXPECT_NEAR(u.highest, 5.0, 1e-13);
  EXPECT_NEAR(u.lowest, 0.0, 1e-13);
  EXPECT_NEAR(*u.speed, 10.0, 1e-13);
  // integrals of 5 t^2 over [0, 1] and of 5 - 5 t + 5 t^2 over [0, 1/2], and of their squares
  EXPECT_NEAR(u.mean, (5.0 / 3.0 + 2.5 - 0.625 + 5.0 / 24.0) / 1.5, 1e-13);
  EXPECT_NEAR(u.rms * u.rms,
              (5.0 + 25.0 * (0.5 - 0.25 + 3.0 / 24.0 - 2.0 / 64.0 + 1.0 / 160.0)) / 1.5, 1e-12);
  EXPECT_FALSE(u.harmonic.has_value());
  EXPECT_EQ(found.stops[0].impacts, 1);
  EXPECT_NEAR(found.stops[0].impulse, 2.0 * 15.0, 1e-12);
  EXPECT_FALSE(found.stops[0].peak_force.has_value());
  // From later on: the way up alone.
  options.measure->from = 1.25;
  const Amplitudes late = *simulate(system, support::rest(system), options).amplitudes;
  EXPECT_NEAR(late.duration, 0.25, 1e-13);
  EXPECT_NEAR(late.rows[0].highest, 5.0 - 1.25 + 0.3125, 1e-13);
  EXPECT_NEAR(late.rows[0].lowest, 3.75, 1e-13);
  EXPECT_NEAR(*late.rows[0].speed, 2.5, 1e-13);
  EXPECT_EQ(late.stops[0].impacts, 0);
  EXPECT_EQ(late.stops[0].impulse, 0.0);
  EXPECT_EQ(*late.stops[0].peak_force, 0.0);
}

// A mass of 1 on a spring of 100 N/m that it meets at 3 m/s: half a turn at 10 rad/s.
TEST(Amplitudes, OfAContactWithASpring) {
  System system = support::oscillator(0.0, 0.0, 0.5, 0.0);
  ContactForce law;
  law.stiffness = 100.0;
  law.exponent = 1.0;
  system.stops[0].law = law;
  const double there = 0.5 / 3.0, contact = pi / 10.0, end = there + contact + 0.5;
  const Amplitudes found =
      measured(system, support::state_of({0.0}, {3.0}), support::for_seconds(end));
  EXPECT_NEAR(found.rows[0].highest, 0.8, 1e-12);
  EXPECT_NEAR(found.rows[0].lowest, 0.5 - 1.5, 1e-12);
  EXPECT_NEAR(*found.rows[0].speed, 3.0, 1e-12);
  // 0.25 on the way there and 0.5 s times -0.25 back; 0.5 and 0.3 sin(10 t) between
  const double sum = there * 0.25 + 0.5 * contact + 0.06 - 0.5 * 0.25;
  EXPECT_NEAR(found.rows[0].mean, sum / end, 1e-12);
  const StopLoad& load = found.stops[0];
  EXPECT_EQ(load.impacts, 1);
  EXPECT_NEAR(*load.peak_force, 30.0, 1e-10);
  EXPECT_NEAR(load.impulse, 6.0, 1e-11);
  EXPECT_NEAR(*load.rms_force, std::sqrt(450.0 * contact / end), 1e-10);
  // Cut within the contact, at its middle.
  const Amplitudes half = measured(system, support::state_of({0.0}, {3.0}),
                                   support::for_seconds(end), there + 0.5 * contact);
  EXPECT_NEAR(half.stops[0].impulse, 3.0, 1e-11);
  EXPECT_EQ(half.stops[0].impacts, 0);
}

// Held for ever by a push of 3 + 2 cos t on a mode of frequency 2: the force is what the spring of
// the mode does not take.
TEST(Amplitudes, OfAHeldStructureAreThoseOfItsContactForce) {
  System system = support::forced_oscillator(2.0, 0.1, 0.25, 0.0, 1.0, 2.0);
  system.modal().load = Vector::Constant(1, 4.0);
  const Amplitudes found =
      measured(system, support::state_of({0.25}, {0.0}), support::for_periods(2));
  EXPECT_EQ(found.rows[0].highest, 0.25);
  EXPECT_EQ(found.rows[0].lowest, 0.25);
  EXPECT_NEAR(found.rows[0].rms, 0.25, 1e-14);
  EXPECT_EQ(*found.rows[0].speed, 0.0);
  EXPECT_NEAR(*found.stops[0].peak_force, 5.0, 1e-13);
  EXPECT_NEAR(*found.stops[0].rms_force, std::sqrt(11.0), 1e-13);
  EXPECT_NEAR(found.stops[0].impulse, 12.0 * pi, 1e-12);
}

}  // namespace
}  // namespace graze
