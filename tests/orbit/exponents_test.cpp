// Lyapunov exponents through impacts, against identities and closed forms.
#include "graze/orbit/exponents.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/angle.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/orbit/search/settled.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

constexpr double kLost = -std::numeric_limits<double>::infinity();

ExponentOptions over(long long periods) {
  ExponentOptions options;
  options.periods = periods;
  options.closure_speed = 1e-9;
  return options;
}

// The flow shrinks volumes by e^{-2 sum delta t}, every impact by r^2.
double sum_by_identity(const System& system, const Exponents& exponents) {
  const double r = system.stops[0].restitution().at_rest();
  const double time = static_cast<double>(exponents.periods) * system.period();
  return -2.0 * system.delta().sum() +
         static_cast<double>(exponents.impacts) * 2.0 * std::log(r) / time;
}

TEST(Exponents, AddUpToWhatVolumesDo) {
  struct Case {
    const char* scene;
    double frequency;
  };
  for (const Case& one : {Case{"05_wagg_one_mode", 70.0}, Case{"02_wagg_momentum", 66.0},
                          Case{"02_wagg_momentum", 60.0}}) {
    SCOPED_TRACE(testing::Message() << one.scene << " " << one.frequency);
    const Scene scene = support::shipped_scene(
        one.scene, {"stop.restitution=0.9", "forcing.frequency=" + std::to_string(one.frequency)});
    const System system = assemble(scene);
    const Exponents exponents = lyapunov_exponents(system, initial_state(scene, system), over(180));
    ASSERT_EQ(exponents.failure, "");
    ASSERT_EQ(exponents.lost, 0);
    EXPECT_EQ(exponents.periods, 180);
    EXPECT_GT(exponents.impacts, 100);
    const double sum = sum_by_identity(system, exponents);
    EXPECT_NEAR(exponents.values.sum() / sum, 1.0, 1e-8);
    for (Eigen::Index j = 1; j < exponents.values.size(); ++j)
      EXPECT_GE(exponents.values[j - 1], exponents.values[j]);
  }
}

// Where no stop is met they are the rates of decay, two for every mode.
TEST(Exponents, OfAClearMotionAreRatesOfDecay) {
  const Scene scene = support::shipped_scene("02_wagg_momentum", {"stop.gap=1.0"});
  const System system = assemble(scene);
  ExponentOptions options = over(1);
  options.repeats = 1;
  const Exponents exponents = lyapunov_exponents(system, initial_state(scene, system), options);
  ASSERT_EQ(exponents.failure, "");
  Vector rates(2 * system.modes());
  rates << -system.delta(), -system.delta();
  std::sort(rates.begin(), rates.end(), std::greater<>());
  for (Eigen::Index j = 0; j < rates.size(); ++j)
    EXPECT_NEAR(exponents.values[j] / rates[j], 1.0, 1e-9) << j;
}

// Of a stable orbit they are the logarithms of its multipliers, by either way.
TEST(Exponents, OfAnOrbitAreThoseOfItsMultipliers) {
  const System system = assemble(support::reference_scene("orbits/sdof_1_6"));
  const FoundOrbits found = find_orbits(system, support::rest(system), {});
  int seen = 0;
  for (const Orbit& orbit : found.orbits) {
    if (orbit.stable != true || !orbit.admissible || orbit.sticks()) continue;
    ++seen;
    const SettledMotion settled = settle(system, support::rest(system));
    ASSERT_EQ(settled.period, orbit.period);
    ExponentOptions options = over(2000);
    const Exponents average = lyapunov_exponents(system, settled.at_end, options);
    options.repeats = orbit.period;
    const Exponents exact = lyapunov_exponents(system, settled.at_end, options);
    const double time = orbit.period * system.period();
    for (std::size_t j = 0; j < orbit.multipliers.size(); ++j) {
      const auto at = static_cast<Eigen::Index>(j);
      const double exponent = std::log(std::abs(orbit.multipliers[j].value)) / time;
      EXPECT_NEAR(exact.values[at], exponent, 1e-6 * std::abs(exponent)) << j;
      // The directions of a pair turn within it.
      EXPECT_NEAR(average.values[at], exponent, 0.02 * std::abs(exponent)) << j;
    }
  }
  EXPECT_GE(seen, 1);
}

// A ball on a table that shakes it high: K = 2 (1 + r) a/g is the stretch of the phase from impact
// to impact, a the table's largest acceleration, and where every phase is as likely the exponent is
// ln(K/2) per impact, as of Chirikov's standard map (Phys. Rep. 52 (1979) 263-379). That holds for
// balls much faster than the table, r -> 1.
TEST(Exponents, OfABallOnAShakenTable) {
  struct Case {
    double a, r, per_impact, error;
  };
  // From the map of the impacts in closed form, 2e5 of them, in another language; the last one also
  // by Chirikov's formula, 4.600.
  for (const Case& one : {Case{10.0, 0.9, 2.778, 0.01}, Case{50.0, 0.9, 4.356, 0.01},
                          Case{50.0, 0.99, 4.582, 0.02}}) {
    SCOPED_TRACE(testing::Message() << one.a << " " << one.r);
    System system{Vector::Zero(1), NaturalModes{Vector::Zero(1)}, {}};
    system.modal().load = Vector::Constant(1, 1.0);
    system.modal().forcing = HarmonicForcing{1.0, 0.3, Vector::Constant(1, one.a)};
    system.stops.push_back({Vector::Ones(1), 0.0, ImpactLaw{Vector::Ones(1), one.r}});
    const Exponents exponents =
        lyapunov_exponents(system, support::state_of({-10.0}, {0.0}), over(150'000));
    ASSERT_EQ(exponents.failure, "");
    ASSERT_EQ(exponents.lost, 0);
    const double time = static_cast<double>(exponents.periods) * system.period(),
                 impacts = static_cast<double>(exponents.impacts);
    ASSERT_GT(impacts, 500.0);
    // Of ln |cos| over all phases the standard deviation is pi/sqrt(12).
    const double error = std::hypot(one.error, kTurn / 2.0 / std::sqrt(12.0 * impacts));
    EXPECT_NEAR(exponents.values[0] * time / impacts, one.per_impact, 3.0 * error);
    if (one.r > 0.95) {
      EXPECT_NEAR(exponents.values[0] * time / impacts, std::log((1.0 + one.r) * one.a),
                  3.0 * error);
    }
    EXPECT_NEAR(exponents.values.sum() * time / impacts, 2.0 * std::log(one.r), 1e-9);
  }
}

// Rest on the stop in every period ends what was between neighbours in (b.q, b.q').
TEST(Exponents, AreLostWhereTheMotionSticks) {
  System system = support::forced_oscillator(1.0, 0.05, 0.1, 0.3, 0.3, 1.0);
  const SettledMotion one = settle(system, support::rest(system));
  ASSERT_EQ(one.kind, SettledKind::kSticks);
  for (const int repeats : {0, one.period}) {
    ExponentOptions options = over(40);
    options.repeats = repeats;
    const Exponents exponents = lyapunov_exponents(system, one.at_end, options);
    ASSERT_EQ(exponents.failure, "");
    EXPECT_EQ(exponents.lost, 2);
    EXPECT_EQ(exponents.values[0], kLost);
  }
}

// Without damping and far from its stop a linear oscillator never repeats where its frequency and
// the forcing's have no ratio of whole numbers; its exponents are both 0.
TEST(Exponents, OfATorusAreZero) {
  const System system = support::forced_oscillator(std::sqrt(2.0), 0.0, 100.0, 0.3, 0.8, 1.0);
  const Exponents exponents =
      lyapunov_exponents(system, support::state_of({1.0}, {0.5}), over(300));
  ASSERT_EQ(exponents.failure, "");
  EXPECT_EQ(exponents.wandering, Wandering::kTorus);
  const double time = 300.0 * system.period();
  EXPECT_LT(std::abs(exponents.values[0]) * time, std::log(300.0));
}

// What the exponents are not of a torus for: chaos of a ball on a table (above), and decay.
TEST(Exponents, TellChaosAndDecayFromATorus) {
  System ball{Vector::Zero(1), NaturalModes{Vector::Zero(1)}, {}};
  ball.modal().load = Vector::Constant(1, 1.0);
  ball.modal().forcing = HarmonicForcing{1.0, 0.3, Vector::Constant(1, 10.0)};
  ball.stops.push_back({Vector::Ones(1), 0.0, ImpactLaw{Vector::Ones(1), 0.9}});
  EXPECT_EQ(lyapunov_exponents(ball, support::state_of({-10.0}, {0.0}), over(2000)).wandering,
            Wandering::kChaos);
  const System decays = support::forced_oscillator(std::sqrt(2.0), 0.01, 100.0, 0.3, 0.8, 1.0);
  EXPECT_EQ(lyapunov_exponents(decays, support::state_of({1.0}, {0.5}), over(300)).wandering,
            Wandering::kOpen);
}

// Decay by a factor e^3 over the average is within the factor 300, but comes nearer to its orbit.
TEST(Exponents, OfASlowApproachAreNotOfATorus) {
  const System system = support::forced_oscillator(std::sqrt(2.0), 0.00127, 100.0, 0.3, 0.8, 1.0);
  const Exponents exponents =
      lyapunov_exponents(system, support::state_of({1.0}, {0.5}), over(300));
  const double growth = 300.0 * system.period() * exponents.values[0];
  EXPECT_NEAR(growth, -0.00127 * 300.0 * system.period(), 0.2);
  EXPECT_GT(growth, -std::log(300.0));
  EXPECT_EQ(exponents.wandering, Wandering::kOpen);
}

TEST(Exponents, OfOtherModesAreKeptWhereTheMotionSticks) {
  const Scene scene = support::shipped_scene(
      "02_wagg_momentum", {"beam.modes=2", "stop.restitution=0.1", "forcing.frequency=42"});
  const System system = assemble(scene);
  const SettledMotion settled = settle(system, initial_state(scene, system));
  ASSERT_EQ(settled.kind, SettledKind::kSticks) << settled.classification;
  for (const int repeats : {0, settled.period}) {
    ExponentOptions options = over(200);
    options.repeats = repeats;
    const Exponents exponents = lyapunov_exponents(system, settled.at_end, options);
    ASSERT_EQ(exponents.failure, "");
    EXPECT_EQ(exponents.lost, 2);
    EXPECT_TRUE(std::isfinite(exponents.values[1]));
    EXPECT_LT(exponents.values[0], 0.0);
  }
}

}  // namespace
}  // namespace graze
