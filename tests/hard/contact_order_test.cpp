// S4: the order of Runge-Kutta steps across a contact. A body against an elastic spring: it leaves
// as fast as it came, after pi sqrt(m/k) (linear) or 2.9432751843247 x_max/v (Hertz; Johnson,
// Contact Mechanics, section 11.4), written down here and not taken from the program.
#include "graze/study/compare/contact_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/reached.hpp"

namespace graze {
namespace {

using support::expect_reached;
using support::off;

const ElasticContact kLinear = {0.3, 0.2, 1e6, 1.0};
const ElasticContact kHertz = {0.1, 0.1, 3e9, 1.5};
const double kLinearDuration = std::numbers::pi * std::sqrt(0.3 / 1e6);
const double kHertzDuration = 2.9432751843247 * 1.11664597110381e-5 / 0.1;

double error(const ContactCrossing& crossing, double speed, double duration) {
  EXPECT_TRUE(crossing.ended);
  return std::max(std::abs(crossing.speed / speed - 1.0),
                  std::abs(crossing.duration / duration - 1.0));
}

// From some 40 steps a contact to 16 times as many; the worst of places spread over the step, for
// where in it the contact begins and ends is chance.
template <class Cross>
double order(double speed, double duration, const Cross& cross) {
  constexpr int kPlaces = 11;
  const auto worst = [&](int steps) {
    double largest = 0.0;
    for (int i = 0; i < kPlaces; ++i) {
      const double step = duration / (steps + (i + 0.5) / kPlaces);
      const double lead = ((4 * i) % kPlaces + 0.5) / kPlaces * step;
      largest = std::max(largest, error(cross(step, lead), speed, duration));
    }
    return largest;
  };
  return std::log2(worst(40) / worst(640)) / 4.0;
}

double located(const ElasticContact& contact, double duration) {
  return order(contact.speed, duration,
               [&](double step, double) { return cross_with_location(contact, step); });
}

double not_located(const ElasticContact& contact, double duration) {
  return order(contact.speed, duration, [&](double step, double lead) {
    return cross_without_location(contact, step, lead);
  });
}

// 4 is the order of the method, 2 that of the corner in the force, 5/2 that of x^(3/2) at x = 0.
TEST(HardCases, S4OrderAcrossAContact) {
  expect_reached("S4", "rk4, linear spring, contact located: order 4",
                 off(located(kLinear, kLinearDuration), 4.0), 0.2);
  expect_reached("S4", "rk4, linear spring, not located: order 2",
                 off(not_located(kLinear, kLinearDuration), 2.0), 0.2);
  expect_reached("S4", "rk4, Hertz, contact located: order 5/2",
                 off(located(kHertz, kHertzDuration), 2.5), 0.2);
  expect_reached("S4", "rk4, Hertz, not located: order 5/2",
                 off(not_located(kHertz, kHertzDuration), 2.5), 0.2);
}

// The table that `graze cost` prints: its slopes, and what it takes for the truth.
TEST(HardCases, S4TheTableOfCost) {
  EXPECT_NEAR(kLinear.duration() / kLinearDuration, 1.0, 1e-14);
  EXPECT_NEAR(kHertz.duration() / kHertzDuration, 1.0, 1e-13);
  const std::vector<ContactOrder> lines = contact_orders(kHertz);
  ASSERT_EQ(lines.size(), 6u);
  for (const ContactOrder& line : lines) {
    SCOPED_TRACE(line.spring + ", " + line.method);
    // All springs give way as far.
    EXPECT_NEAR(line.contact.depth() / 1.11664597110381e-5, 1.0, 1e-12);
    const bool linear = line.spring == "linear";
    EXPECT_EQ(line.contact.exponent, linear ? 1.0 : 1.5);
    if (line.method == "exact") {
      expect_reached("S4", "exact flow, the same contacts: speed and duration, relative",
                     line.rows.front().error, 1e-11);
      continue;
    }
    const bool at = line.method == "rk4, located";
    expect_reached("S4", "slopes that graze cost prints: 4, 2 and 5/2",
                   off(line.order, !linear ? 2.5
                                   : at    ? 4.0
                                           : 2.0),
                   0.2);
  }
}

}  // namespace
}  // namespace graze
