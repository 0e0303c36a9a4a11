// Contacts with a spring, entered and left: closed forms (hard cases S1 to S3), by extrapolation
// and by series.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "graze/contact/detail/restitution_damping.hpp"
#include "graze/flow/stepped/detail/step_methods.hpp"

namespace graze {
namespace {

// A free mass (kg) before a spring, at rest displacement `from` (m).
struct Body {
  double mass = 1.0;
  ContactForce law;
  double from = 0.0;
};

struct Parted {
  double duration = 0.0;  // s
  double depth = 0.0, speed = 0.0;
  double peak = 0.0;  // N
  long long evaluations = 0;
};

SprungSystem system_of(const Body& body) {
  const Vector row = Vector::Constant(1, 1.0 / std::sqrt(body.mass));
  SprungSystem system{
      Matrix::Zero(1, 1), Matrix::Zero(1, 1), Vector::Zero(1), Vector::Zero(1), 0.0, {}};
  system.springs.push_back({body.law, row, row, true});
  return system;
}

using Method = std::unique_ptr<StepFlow> (*)(const SprungSystem&, const StepSetting&);

class SprungFlow : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(ByExtrapolationAndSeries, SprungFlow,
                         testing::Values(&bulirsch_stoer_flow, &contact_flow));

Parted parted(const Body& body, double v, double tolerance = 1e-14) {
  StepSetting setting;
  setting.tolerance = tolerance;
  setting.speed = 1.0;
  setting.longest = 1.0;
  const auto flow = SprungFlow::GetParam()(system_of(body), setting);
  const double root = std::sqrt(body.mass);
  Vector x(2);
  x << root * body.from, root * v;
  const std::array<double, 1> depths = {0.0};
  flow->start(0.0, x, depths);
  Watch depth;
  depth.of_spring = SpringWatch::kDepth;
  depth.spring = 0;
  depth.multiplicity = 1;
  depth.departure = v;
  Watch grip = depth;
  grip.of_spring = SpringWatch::kGrip;
  grip.multiplicity = 0;
  std::vector<const Watch*> watches = {&depth};
  if (body.law.parts_early()) watches.push_back(&grip);
  const StepDescent found = flow->first_descent(watches, 1e3, 1e3, {});
  EXPECT_GE(found.watch, 0);
  flow->state(found.s, x);
  return {found.s, x[0] / root - body.from, -x[1] / root, flow->peak_force(0), flow->evaluations()};
}

ContactForce hertz(double k) { return {k, 1.5, ContactDamping::kNone, 0.0, 0.0, 0.0, {}}; }

// x_max = (5 m v^2/(4 k))^(2/5), duration 2.9432751843247 x_max/v.
TEST_P(SprungFlow, S1HertzElastic) {
  const auto expect = [](double k, double m, double v, double deepest, double duration,
                         double from) {
    SCOPED_TRACE(v);
    EXPECT_NEAR(std::pow(1.25 * m * v * v / k, 0.4) / deepest, 1.0, 1e-13);
    const Parted body = parted({m, hertz(k), from}, v);
    EXPECT_NEAR(body.duration / duration, 1.0, 1e-10);
    EXPECT_NEAR(body.speed / v, 1.0, 1e-12);
    EXPECT_NEAR(body.peak / (k * std::pow(deepest, 1.5)), 1.0, 1e-12);
    EXPECT_LE(std::abs(body.depth), 1e-10 * deepest + 1e-15 * std::abs(from));
    EXPECT_LT(body.evaluations, 4000);
  };
  expect(3e9, 0.1, 0.1, 1.11664597110381e-5, 3.286596376426e-4, 0.0);
  expect(3e9, 1.0, 1e-6, 2.8048878636155e-9, 8.25555684379303e-3, 0.0);
  EXPECT_NEAR(parted({0.1, hertz(3e9), 0.0}, 0.1).peak, 111.942373173511, 1e-10);
  // Far from the place of rest: the depth keeps its digits.
  expect(3e9, 1.0, 1e-6, 2.8048878636155e-9, 8.25555684379303e-3, 0.01);
}

// Half a period of the spring, or where its damping ends it.
TEST_P(SprungFlow, S2SpringDashpot) {
  const double k = 1e6, m = 0.3, v = 0.2, w = std::sqrt(k / m);
  for (const double zeta : {0.0, 0.05, 0.3, 0.9}) {
    SCOPED_TRACE(zeta);
    ContactForce law{k,   1.0, ContactDamping::kConstant, 2.0 * zeta * std::sqrt(k * m),
                     0.0, 0.0, Separation::kAtZeroDepth};
    const Parted at_depth = parted({m, law, 0.0}, v);
    const double turn = std::sqrt(1.0 - zeta * zeta);
    EXPECT_NEAR(at_depth.duration * w * turn, std::numbers::pi, 1e-10);
    EXPECT_NEAR(at_depth.speed / v, restitution_at_zero_depth(zeta), 1e-11);
    if (zeta == 0.0) continue;
    law.separation = Separation::kAtZeroForce;
    const Parted at_force = parted({m, law, 0.0}, v);
    EXPECT_NEAR(at_force.duration * w * turn, 2.0 * std::acos(zeta), 1e-10);
    EXPECT_NEAR(at_force.speed / v, restitution_at_zero_force(zeta), 1e-11);
    EXPECT_GT(at_force.depth, 0.0);
  }
}

TEST_P(SprungFlow, S3HuntCrossley) {
  const double k = 2e8, m = 0.5, v = 0.3;
  for (const double n : {1.0, 1.5, 2.2})
    for (const double a : {0.1, 1.0, 10.0}) {
      SCOPED_TRACE(n);
      const ContactForce law{k, n, ContactDamping::kPower, a * k / v, 0.0, 0.0, {}};
      const Parted body = parted({m, law, 0.0}, v);
      EXPECT_NEAR(body.speed / v, restitution_of_power_damping(a), 1e-10) << a;
    }
}

// At other settings than the ones printed: the error follows the tolerance.
TEST_P(SprungFlow, ErrorFollowsTheTolerance) {
  const double v = 0.7, deepest = std::pow(1.25 * 0.02 * v * v / 5e8, 0.4);
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    const Parted body = parted({0.02, hertz(5e8), 0.0}, v, tolerance);
    EXPECT_NEAR(body.duration * v / (2.9432751843247 * deepest), 1.0, 100.0 * tolerance);
    EXPECT_NEAR(body.speed / v, 1.0, 100.0 * tolerance);
  }
}

// A stop beside the spring that is left at 1e-8 m/s and met again 2 ns later, 1 cm from where
// displacements count: the gap in between is smaller than the rounding of the displacement.
TEST_P(SprungFlow, AShortFlightOffAStopKeepsItsDigits) {
  const double v = 1e-8, push = 9.8, place = 0.01;
  SprungSystem system{
      Vector::Zero(2), Vector::Zero(2), Vector{{push, 0.0}}, Vector::Zero(2), 0.0, {}, {}, {}};
  const Vector row{{0.0, 1.0}};
  system.springs.push_back({hertz(3e9), row, row, true, row});
  StepSetting setting;
  setting.tolerance = 1e-14;
  setting.speed = 1.0;
  setting.longest = std::numeric_limits<double>::infinity();
  const auto flow = GetParam()(system, setting);
  Watch gap;
  gap.weights = Vector{{-1.0, 0.0, 0.0, 0.0}};
  gap.constant = place;
  gap.multiplicity = 1;
  gap.departure = v;
  const std::array<double, 1> depths = {1e-6};
  flow->start(0.0, Vector{{place, 1e-6, -v, 0.02}}, depths);
  const std::array<const Watch*, 1> watches = {&gap};
  const StepDescent found = flow->first_descent(watches, 1e-3, 1e-3, {});
  EXPECT_EQ(found.watch, 0);
  EXPECT_NEAR(found.s / (2.0 * v / push), 1.0, 1e-9);
}

}  // namespace
}  // namespace graze
