// Modes that are soft, or driven slowly, against the motion between stops: nothing may cancel.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/flow/detail/phase_choice.hpp"
#include "graze/flow/exact/extended.hpp"
#include "graze/flow/variation/arc_work.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::oscillator;
using Wide = RealVector<Extended>;

constexpr double kGravity = 9.81;

System loaded(double omega, double delta) {
  System system = oscillator(omega, delta, 1.0, 0.8);
  system.modal().load = Vector::Constant(1, kGravity);
  return system;
}

// Displacement and velocity over s against 50 digits, relative to what start and forces add to
// them: a speed is felt no longer than it lasts.
void expect_as_in_fifty_digits(const System& system, double q0, double v0, double s,
                               double allowed) {
  const ExactFlow<double> flow(system);
  const ExactFlow<Extended> wide_flow(system);
  Arc<double> arc(flow);
  Arc<Extended> wide_arc(wide_flow);
  const double theta = 0.7;
  arc.start(theta, Vector::Constant(1, q0), Vector::Constant(1, v0));
  wide_arc.start(theta, Wide::Constant(1, q0), Wide::Constant(1, v0));
  Vector q(1), v(1);
  Wide wide_q(1), wide_v(1);
  arc.state(s, q, v);
  wide_arc.state(s, wide_q, wide_v);
  const double omega = system.omega[0], delta = system.delta()[0];
  const double felt = s / (1.0 + s * std::max(omega, delta));
  const double push = (system.load() ? kGravity : 0.0) + (system.forcing() ? 1.0 : 0.0) +
                      omega * omega * std::abs(q0);
  SCOPED_TRACE(testing::Message() << "omega " << omega << ", delta " << delta << ", s " << s);
  EXPECT_NEAR(q[0], static_cast<double>(wide_q[0]),
              allowed * (std::abs(q0) + std::abs(v0) * felt + push * felt * s));
  EXPECT_NEAR(v[0], static_cast<double>(wide_v[0]), allowed * (std::abs(v0) + push * felt));
}

TEST(SoftMode, UnderLoadAsInFiftyDigits) {
  for (int k = 1; k <= 12; ++k) {
    const double omega = std::pow(10.0, -k);
    for (const double delta : {0.0, 0.1 * omega, omega, 3.0 * omega, 1e-3, 1.0, 1e4})
      for (const double s : {1e-6, 1e-3, 0.45, 3.0})
        expect_as_in_fifty_digits(loaded(omega, delta), 1.0, -3.5, s, 1e-13);
  }
}

// The harmonic response is taken out of the motion up to 4096 times the gap.
TEST(SoftMode, DrivenSlowlyAsInFiftyDigits) {
  for (int k = 1; k <= 9; ++k) {
    const double frequency = std::pow(10.0, -k);
    for (const double omega : {0.0, 1e-12, 0.1 * frequency, frequency, 10.0 * frequency})
      for (const double delta : {0.0, 0.1 * omega, omega, 3.0 * omega, 1.0, 1e4})
        for (const double s : {1e-6, 1e-3, 0.45, 3.0}) {
          const System system =
              support::forced(oscillator(omega, delta, 1.0, 0.8), frequency, 0.0, Vector::Ones(1));
          expect_as_in_fifty_digits(system, 1.0, -3.5, s, 1e-12);
        }
  }
}

// v = c/(2 delta) (1 - e^{-2 delta s}): what a heavily damped free mass under a load dissipates.
TEST(SoftMode, HeavilyDampedFreeMassDissipatesAsInClosedForm) {
  for (const double delta : {5e-4, 0.5, 5e3, 5e7}) {
    for (const double s : {1e-3, 1.0, 7e3, 1e9}) {
      const System system = loaded(0.0, delta);
      const auto phase = make_contact_phase<double>(system, {});
      phase->start(0.0, Vector::Zero(1), Vector::Zero(1));
      const Work work = work_along(system, *phase, s);
      const Extended d = delta, t = s, c = kGravity;
      const Extended expected =
          c * c / (2 * d) *
          (t + expm1(Extended(-2 * d * t)) / d - expm1(Extended(-4 * d * t)) / (4 * d));
      EXPECT_NEAR(work.dissipation / static_cast<double>(expected), 1.0, 1e-12)
          << "delta " << delta << ", s " << s;
      const Extended reached = c / (2 * d) * (t + expm1(Extended(-2 * d * t)) / (2 * d));
      EXPECT_NEAR(work.load / static_cast<double>(c * reached), 1.0, 1e-12)
          << "delta " << delta << ", s " << s;
    }
  }
}

}  // namespace
}  // namespace graze
