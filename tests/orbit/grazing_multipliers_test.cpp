// Multipliers of orbits that graze, as limits of those that impact ever more slowly.
#include "graze/orbit/problem/detail/grazing_multipliers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "graze/base/angle.hpp"
#include "graze/orbit/closed_form/detail/periodic_response.hpp"
#include "graze/orbit/problem/orbit.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// Two modes, and with them the row and the damping of a random scene whose grazing was told wrong.
System two_modes(double second_damping) {
  System system;
  system.omega = Vector{{1.0, 5.038982107768481}};
  system.modal().delta = Vector{{0.03, second_damping * 5.038982107768481}};
  system.modal().forcing =
      HarmonicForcing{0.638860173981165, -2.6488888828114447, Vector{{1.0, 0.2995833008697377}}};
  const Vector row{{1.0, -0.19389917574482163}};
  system.stops.push_back(
      {row, 1.0, ImpactLaw{row / row.squaredNorm(), Restitution{0.5230813333303654}}});
  return system;
}

// Where the response without the stop is largest at it: a grazing, were the stop there. Its state,
// with a speed towards the stop.
ImpactPoint peak(const System& system, double speed) {
  const PeriodicResponseAnswer answer = periodic_response(system, 1);
  double theta = 0.0, largest = -1e300;
  for (int k = 0; k < 4096; ++k) {
    const RowMotion at = answer.response->forced(0, kTurn * k / 4096);
    if (at.value > largest) {
      largest = at.value;
      theta = kTurn * k / 4096;
    }
  }
  for (int k = 0; k < 60; ++k) {  // the rate is zero there
    const State state = answer.response->forced_state(theta);
    const double rate = system.stops[0].row.dot(state.qdot);
    const double push = system.stops[0].row.dot(vector_field(system, state, theta).qdot);
    theta -= system.forcing()->frequency * rate / push;
  }
  State state = answer.response->forced_state(theta);
  const Vector& row = system.stops[0].row;
  state.qdot += (speed - row.dot(state.qdot)) / row.squaredNorm() * row;
  return {theta, state};
}

// Those that stay finite approach their limit as the speed, and the last one grows as its inverse.
TEST(GrazingMultipliers, AreTheLimitOfThoseOfSlowImpacts) {
  for (const double damping : {0.02, 0.18715916382755424}) {
    const System system = two_modes(damping);
    const ImpactPoint grazing = peak(system, 1e-18);
    const std::vector<Eigenvalue> limit = orbit_multipliers(system, {1, {0}}, {grazing});
    const double left = std::abs(system.stops[0].row.dot(grazing.before.qdot));  // by rounding
    ASSERT_GT(left, 0.0);
    ASSERT_EQ(limit.size(), 4u);
    EXPECT_GT(std::abs(limit[0].value), 1e12);
    EXPECT_LT(std::abs(limit[3].value), 1e-9);  // falls as the speed
    std::vector<double> away;
    for (const double speed : {1e-5, 1e-6}) {
      const std::vector<Eigenvalue> slow =
          orbit_multipliers(system, {1, {0}}, {peak(system, speed)});
      ASSERT_EQ(slow.size(), 4u);
      EXPECT_NEAR((slow[0].value * speed / (limit[0].value * left)).real(), 1.0, 1e3 * speed);
      away.push_back(std::abs(slow[1].value - limit[1].value) +
                     std::abs(slow[2].value - limit[2].value));
    }
    EXPECT_LT(away[0], 1e-2);
    EXPECT_NEAR(away[1] / away[0], 0.1, 0.02);
    // From either side of the rounding of the speed.
    const std::vector<Eigenvalue> behind =
        orbit_multipliers(system, {1, {0}}, {peak(system, -1e-18)});
    EXPECT_EQ(count_multipliers(behind).outside, count_multipliers(limit).outside);
  }
}

}  // namespace
}  // namespace graze
