// The smallest interior minimum of the gap, against dense sampling and closed forms.
#include "graze/motion/detail/clearance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/random_system.hpp"

namespace graze {
namespace {

ArcCurve<double> curve_of(const System& system, const Arc<double>& arc, double window) {
  return {arc, gap_observable<double>(system.stops[0].row, system.stops[0].gap), window, false};
}

TEST(Clearance, OfASineIsItsCrest) {
  const System system = support::oscillator(2.0, 0.0, 1.0, 0.8);
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  arc.start(0.0, Vector::Zero(1), Vector::Constant(1, 0.6));  // q = .3 sin(2 s)
  const double crest = std::numbers::pi / 4.0;
  const auto minimum = smallest_minimum(curve_of(system, arc, crest + 0.1));
  ASSERT_TRUE(minimum);
  EXPECT_NEAR(*minimum, 0.7, 1e-15);
  EXPECT_FALSE(smallest_minimum(curve_of(system, arc, crest - 0.1)));
}

TEST(Clearance, OfADampedOscillationIsItsFirstCrest) {
  const System system = support::oscillator(1.0, 0.1, 1.0, 0.8);
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  arc.start(0.0, Vector::Zero(1), Vector::Ones(1));
  const double wd = std::sqrt(0.99), crest = std::atan2(wd, 0.1) / wd;
  const double height = std::exp(-0.1 * crest) * std::sin(wd * crest) / wd;
  const auto minimum = smallest_minimum(curve_of(system, arc, 30.0));
  ASSERT_TRUE(minimum);
  EXPECT_NEAR(*minimum, 1.0 - height, 1e-14);
}

TEST(Clearance, IsNothingForAMonotoneApproach) {
  System system = support::oscillator(1.0, 2.0, 1.0, 0.8);  // overdamped
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  arc.start(0.0, Vector::Constant(1, -0.5), Vector::Zero(1));
  EXPECT_FALSE(smallest_minimum(curve_of(system, arc, 50.0)));
}

// Only minima below what is asked for count.
TEST(Clearance, OfWhatLiesBelowALevel) {
  const System system = support::oscillator(1.0, 0.1, 1.0, 0.8);
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  arc.start(0.0, Vector::Zero(1), Vector::Ones(1));
  const ArcCurve<double> curve = curve_of(system, arc, 30.0);
  const double smallest = *smallest_minimum(curve);
  // The instant of a minimum is known to rounding, and so is its gap.
  EXPECT_FALSE(lowest_minimum(curve, 0, smallest - 1e-14));
  EXPECT_FALSE(lowest_minimum(curve, 0, -1.0));
  for (const double above : {1e-12, 1e-3, 0.5, 10.0}) {
    const auto minimum = lowest_minimum(curve, 0, smallest + above);
    ASSERT_TRUE(minimum) << above;
    EXPECT_NEAR(minimum->gap, smallest, 1e-14) << above;
  }
}

TEST(Clearance, AgreesWithDenseSampling) {
  constexpr int kSamples = 20'000;
  int minima = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    support::Dice dice(seed);
    const System system = support::random_system(dice, 1 + dice.pick(4), 0.5);
    const ExactFlow<double> flow(system);
    Arc<double> arc(flow);
    arc.start(system.forcing()->phase, dice.vector(system.modes(), -0.5, 0.5),
              dice.vector(system.modes(), -1.0, 1.0));
    const double window = system.period(), h = window / kSamples;
    const ArcCurve<double> curve = curve_of(system, arc, window);
    Vector q(system.modes()), qdot(system.modes());
    std::optional<double> sampled;
    double before = 0.0, here = 0.0;
    for (int i = 0; i <= kSamples; ++i) {
      arc.state(h * i, q, qdot);
      const double after = system.stops[0].gap - system.stops[0].row.dot(q);
      if (i >= 2 && here < before && here < after && (!sampled || here < *sampled)) sampled = here;
      before = here;
      here = after;
    }
    const std::optional<double> minimum = smallest_minimum(curve);
    // Sampling can miss a shallow minimum, but not one deeper than a sample's distance can hide.
    const double hidden = 0.5 * curve.at(0.0, 0).bound * h * h + 1e-13;
    if (sampled) {
      ASSERT_TRUE(minimum) << "seed " << seed;
      ++minima;
      EXPECT_LE(*minimum, *sampled + 1e-13) << "seed " << seed;
      EXPECT_GE(*minimum, *sampled - hidden) << "seed " << seed;
    }
  }
  EXPECT_GT(minima, 50);
}

}  // namespace
}  // namespace graze
