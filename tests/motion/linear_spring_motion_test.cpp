// Motions over linear springs in closed form, against the same integrated step by step: a law with
// the exponent 1 + eps is no linear one, and differs from it by rounding.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "graze/motion/simulation.hpp"
#include "support/random_system.hpp"

namespace graze {
namespace {

// Springs from soft to hard, a third of them without damping, some nearly critical for the mass
// that they meet.
ContactForce random_law(support::Dice& dice, double mass) {
  ContactForce law;
  law.stiffness = std::pow(10.0, dice.uniform(1.0, 6.0));
  law.exponent = 1.0;
  const double critical = 2.0 * std::sqrt(law.stiffness * mass);
  const int kind = dice.pick(3);
  if (kind == 0) return law;
  law.damping = ContactDamping::kConstant;
  law.coefficient =
      kind == 1 ? dice.uniform(0.0, 1.5) * critical : critical * (1.0 + dice.uniform(-1e-7, 1e-7));
  law.separation = dice.pick(2) == 0 ? Separation::kAtZeroForce : Separation::kAtZeroDepth;
  return law;
}

System integrated(System system) {
  for (Stop& stop : system.stops)
    if (stop.is_compliant()) stop.force().exponent = 1.0 + std::numeric_limits<double>::epsilon();
  return system;
}

// A motion that is known to rounding at its first contacts. Errors grow with each.
TEST(LinearSpringMotion, IsThatOfSteps) {
  support::Dice dice(20261126);
  int contacts = 0, lossy = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const int modes = 1 + dice.pick(5);
    System system = support::random_system(dice, modes, dice.uniform(0.05, 0.5));
    const int stops = 1 + dice.pick(2);
    system.stops.resize(1);
    if (stops == 2) {
      system.stops.push_back(system.stops[0]);
      system.stops[1].row = dice.vector(modes, -1.0, 1.0);
      system.stops[1].gap = dice.uniform(0.05, 0.5);
    }
    for (Stop& stop : system.stops) stop.law = random_law(dice, 1.0 / stop.row.squaredNorm());
    const State start{Vector::Zero(modes), dice.vector(modes, -2.0, 2.0)};
    const auto exact = support::record_run(system, start, support::for_seconds(4.0));
    const auto steps = support::record_run(integrated(system), start, support::for_seconds(4.0));
    ASSERT_EQ(exact.result.outcome, RunOutcome::kReachedEnd) << trial << exact.result.message;
    const std::size_t count =
        std::min<std::size_t>({exact.events.size(), steps.events.size(), std::size_t{6}});
    EXPECT_EQ(exact.events.empty(), steps.events.empty()) << trial;
    for (std::size_t i = 0; i < count; ++i) {
      const Event &a = exact.events[i], &b = steps.events[i];
      ASSERT_EQ(a.kind, b.kind) << trial << " " << i;
      ASSERT_EQ(a.stop, b.stop) << trial << " " << i;
      EXPECT_NEAR(a.time, b.time, 1e-9) << trial << " " << i;
      EXPECT_NEAR(a.speed, b.speed, 1e-8) << trial << " " << i;
      if (a.kind == EventKind::kContact) ++contacts;
      if (a.kind != EventKind::kSeparation) continue;
      EXPECT_NEAR(a.peak_force, b.peak_force, 1e-8 * (1.0 + b.peak_force)) << trial << " " << i;
      EXPECT_NEAR(a.energy_change, b.energy_change, 1e-8) << trial << " " << i;
      if (a.energy_change < 0.0) ++lossy;
    }
  }
  EXPECT_GT(contacts, 150);
  EXPECT_GT(lossy, 50);
}

}  // namespace
}  // namespace graze
