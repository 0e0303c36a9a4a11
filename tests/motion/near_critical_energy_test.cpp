// Near critical damping of a contact two rates of decay nearly are one: the energy balance closes
// there as elsewhere, on either side, however near, and at critical damping itself.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/motion/simulation.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// q'' = -q - k x - C x', x = q - .05, from within the spring up to its surface and beyond. Along it
// the spring gives up k x^2/2 = 125 J, all of which the dashpot takes.
TEST(NearCriticalEnergy, IsBalanced) {
  const double k = 1e5;
  for (int i = -13; i <= 13; ++i) {
    System system = support::oscillator(1.0, 0.0, 0.05, 0.0);
    const double apart = i == 0 ? 0.0 : std::copysign(std::pow(10.0, std::abs(i) - 14.0), i);
    ContactForce law{k, 1.0, ContactDamping::kConstant, 2.0 * std::sqrt(k + 1.0) * (1.0 + apart)};
    law.separation = Separation::kAtZeroDepth;
    system.stops.front().law = law;
    SimulationOptions options = support::for_seconds(10.0);
    options.energy = true;
    const Simulation run = simulate(system, support::state_of({0.1}, {-0.2}), options);
    ASSERT_EQ(run.outcome, RunOutcome::kReachedEnd) << run.message;
    const double passed = 0.5 * k * 0.05 * 0.05;
    EXPECT_LE(std::abs(run.energy->defect()), 1e-14 * passed) << apart;
    RecordProperty("defect " + std::to_string(i), std::to_string(run.energy->defect() / passed));
    if (std::getenv("GRAZE_SHOW"))
      std::printf("%g %g %g\n", apart, run.energy->defect() / passed,
                  run.energy->defect() / run.energy->size());
  }
}

}  // namespace
}  // namespace graze
