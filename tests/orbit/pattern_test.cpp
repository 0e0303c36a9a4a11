// Orbits with several impacts and on several stops, as the finder lists them.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "graze/assembly/assembly.hpp"
#include "graze/base/angle.hpp"
#include "graze/orbit/search/finder.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

FinderOptions searching(int period, std::optional<int> impacts) {
  FinderOptions options;
  options.period = period;
  options.impacts = impacts;
  options.from_closed_form = options.from_simulation = false;
  return options;
}

// x'' + .1 x' + x = cos(W t) between stops at -gap and gap.
System two_sided(double frequency, double gap, double restitution) {
  System system = support::forced_oscillator(1.0, 0.05, gap, restitution, frequency, 1.0);
  system.stops.push_back({-Vector::Ones(1), gap, ImpactLaw{-Vector::Ones(1), restitution}});
  return system;
}

struct SymmetricImpact {
  double phase, speed;
};

// The symmetric orbits, q(t + T/2) = -q(t), that meet each of the two stops once a period, in
// closed form. Let y be the state just before the impact on the upper stop, at phase theta, J =
// diag(1, -r) the jump, E the free flow over half a period and Y the steady forced response, for
// which Y(theta + pi) = -Y(theta). Half a period later the motion is just before the impact on the
// lower stop, and by symmetry at -y:
//
//   E (J y - Y) - Y = -y,     (I + E J) y = (I + E) Y.
//
// y is Re(z e^{i theta}) with constant z, and contact reads |z_1| cos(theta + arg z_1) = gap.
std::vector<SymmetricImpact> symmetric_orbits(double frequency, double gap, double restitution) {
  const double delta = 0.05, omega = 1.0;
  const std::complex<double> forced =
      1.0 / std::complex<double>(omega * omega - frequency * frequency, 2.0 * delta * frequency);
  const double s = std::numbers::pi / frequency;
  const double wd = std::sqrt(omega * omega - delta * delta);
  const double decay = std::exp(-delta * s), c = std::cos(wd * s), n = std::sin(wd * s) / wd;
  Eigen::Matrix2d flow, jump;
  flow << c + delta * n, n, -omega * omega * n, c - delta * n;
  flow *= decay;
  jump << 1.0, 0.0, 0.0, -restitution;
  const Eigen::Matrix2d unit = Eigen::Matrix2d::Identity();
  const Eigen::Vector2cd response(forced, std::complex<double>(0.0, frequency) * forced);
  const Eigen::Matrix2d map = (unit + flow * jump).inverse() * (unit + flow);
  const Eigen::Vector2cd z = map.cast<std::complex<double>>() * response;
  std::vector<SymmetricImpact> orbits;
  if (std::abs(z[0]) < gap) return orbits;
  for (const double sign : {-1.0, 1.0}) {
    const double theta = sign * std::acos(gap / std::abs(z[0])) - std::arg(z[0]);
    orbits.push_back({theta, (z[1] * std::polar(1.0, theta)).real()});
  }
  return orbits;
}

TEST(Patterns, SymmetricOrbitBetweenTwoStopsIsTheClosedForm) {
  int compared = 0;
  for (const double frequency : {0.8, 1.3, 2.1, 3.4})
    for (const double gap : {0.05, 0.2})
      for (const double restitution : {0.5, 0.8}) {
        SCOPED_TRACE(testing::Message() << frequency << " " << gap << " " << restitution);
        FinderOptions options = searching(1, 2);
        options.keep_virtual = true;
        const FoundOrbits found = find_orbits(two_sided(frequency, gap, restitution), {}, options);
        for (const SymmetricImpact& exact : symmetric_orbits(frequency, gap, restitution)) {
          double nearest = 1.0;
          for (const Orbit& orbit : found.orbits) {
            double error = 0.0;
            for (const OrbitImpact& impact : orbit.impacts) {
              const double phase = exact.phase + (impact.stop == 0 ? 0.0 : std::numbers::pi);
              error = std::max({error, std::abs(std::remainder(impact.phase - phase, kTurn)),
                                std::abs(impact.speed - exact.speed)});
            }
            if (orbit.impacts[0].stop != orbit.impacts[1].stop) nearest = std::min(nearest, error);
          }
          EXPECT_LE(nearest, 1e-10);
          ++compared;
        }
      }
  EXPECT_GE(compared, 16);
}

// An orbit of the same system with the stops numbered the other way round.
bool is_relabelled(const Orbit& a, const Orbit& b) {
  if (a.impacts.size() != b.impacts.size()) return false;
  for (std::size_t i = 0; i < a.impacts.size(); ++i)
    if (a.impacts[i].stop != 1 - b.impacts[i].stop ||
        a.impacts[i].period_index != b.impacts[i].period_index ||
        std::abs(a.impacts[i].phase - b.impacts[i].phase) > 1e-10 ||
        std::abs(a.impacts[i].speed - b.impacts[i].speed) > 1e-10)
      return false;
  return true;
}

TEST(Patterns, RelabellingTheStopsChangesNothingElse) {
  for (const double frequency : {0.9, 1.7, 2.6}) {
    System system = two_sided(frequency, 0.15, 0.7);
    system.stops[1].gap = 0.25;
    System swapped = system;
    std::swap(swapped.stops[0], swapped.stops[1]);
    FinderOptions options = searching(1, 2);
    options.keep_virtual = true;
    const FoundOrbits a = find_orbits(system, {}, options), b = find_orbits(swapped, {}, options);
    ASSERT_EQ(a.orbits.size(), b.orbits.size());
    EXPECT_GE(a.orbits.size(), 4u);
    for (std::size_t i = 0; i < a.orbits.size(); ++i)
      EXPECT_TRUE(is_relabelled(a.orbits[i], b.orbits[i])) << frequency << ", orbit " << i;
  }
}

// Four modes between two stops: orbits on one and on both, each an admissible solution, in order.
TEST(Patterns, SeveralStopsOnABeam) {
  const Scene scene = support::shipped_scene("07_two_stops");
  const System system = assemble(scene);
  const FoundOrbits found = find_orbits(system, {}, searching(1, 2));
  ASSERT_FALSE(found.orbits.empty());
  EXPECT_EQ(found.patterns, 3);  // 1 1, 1 2, 2 2
  bool both = false;
  for (const Orbit& orbit : found.orbits) {
    EXPECT_TRUE(orbit.admissible);
    EXPECT_LE(orbit.residual, 1e-11);
    EXPECT_EQ(orbit.period, 1);
    ASSERT_EQ(orbit.impacts.size(), 2u);
    both = both || orbit.impacts[0].stop != orbit.impacts[1].stop;
    // The beam and its stops are symmetric, and so is each of these orbits.
    EXPECT_NEAR(orbit.impacts[1].phase - orbit.impacts[0].phase, std::numbers::pi, 1e-9);
    EXPECT_NEAR(orbit.impacts[1].speed, orbit.impacts[0].speed, 1e-10);
  }
  EXPECT_TRUE(both);
  EXPECT_TRUE(std::is_sorted(found.orbits.begin(), found.orbits.end(), comes_before));
}

bool identical(const Orbit& a, const Orbit& b) {
  if (a.period != b.period || a.impacts.size() != b.impacts.size() || a.residual != b.residual ||
      a.multipliers.size() != b.multipliers.size() || a.clearance != b.clearance)
    return false;
  for (std::size_t i = 0; i < a.impacts.size(); ++i)
    if (a.impacts[i].phase != b.impacts[i].phase || a.impacts[i].speed != b.impacts[i].speed ||
        a.impacts[i].stop != b.impacts[i].stop || a.impacts[i].before.q != b.impacts[i].before.q ||
        a.impacts[i].before.qdot != b.impacts[i].before.qdot)
      return false;
  for (std::size_t i = 0; i < a.multipliers.size(); ++i)
    if (a.multipliers[i].value != b.multipliers[i].value) return false;
  return true;
}

TEST(Patterns, NumberOfThreadsChangesNothing) {
  for (const char* name : {"04_impact_oscillator", "02_wagg_momentum"}) {
    SCOPED_TRACE(name);
    const Scene scene = support::shipped_scene(name);
    const System system = assemble(scene);
    FinderOptions options = searching(2, 2);
    options.keep_virtual = true;
    options.threads = 1;
    const FoundOrbits one = find_orbits(system, {}, options);
    EXPECT_FALSE(one.orbits.empty());
    for (const int threads : {2, 5}) {
      options.threads = threads;
      const FoundOrbits many = find_orbits(system, {}, options);
      ASSERT_EQ(many.orbits.size(), one.orbits.size());
      for (std::size_t i = 0; i < one.orbits.size(); ++i)
        EXPECT_TRUE(identical(one.orbits[i], many.orbits[i])) << threads << " threads, " << i;
      EXPECT_EQ(many.random.converged, one.random.converged);
      EXPECT_EQ(many.inadmissible, one.inadmissible);
    }
  }
}

// Another seed takes other starts and finds the same orbits where there are few.
TEST(Patterns, SeedChangesTheStartsNotTheList) {
  const Scene scene = support::shipped_scene("04_impact_oscillator");
  const System system = assemble(scene);
  FinderOptions options = searching(2, 2);
  options.keep_virtual = true;
  const FoundOrbits first = find_orbits(system, {}, options);
  EXPECT_FALSE(first.orbits.empty());
  for (const std::uint64_t seed : {2, 3, 4}) {
    options.random_seed = seed;
    const FoundOrbits other = find_orbits(system, {}, options);
    ASSERT_EQ(other.orbits.size(), first.orbits.size()) << seed;
    for (std::size_t i = 0; i < first.orbits.size(); ++i)
      EXPECT_NEAR(other.orbits[i].impacts[0].phase, first.orbits[i].impacts[0].phase, 1e-9);
  }
}

// Asked for (2, 2), the finder meets every (1, 1) orbit taken twice; none of them is listed.
TEST(Patterns, OrbitsTakenTwiceAreNotListed) {
  for (const double frequency : {1.6, 2.2, 2.7, 2.8, 3.3}) {
    const System system = support::forced_oscillator(1.0, 0.05, 0.0, 0.8, frequency, 1.0);
    FinderOptions options = searching(2, 2);
    options.keep_virtual = true;
    for (const Orbit& orbit : find_orbits(system, {}, options).orbits) {
      EXPECT_EQ(orbit.period, 2);
      ASSERT_EQ(orbit.impacts.size(), 2u);
      EXPECT_GT(std::abs(std::remainder(orbit.impacts[0].phase - orbit.impacts[1].phase, kTurn)) +
                    std::abs(orbit.impacts[0].speed - orbit.impacts[1].speed),
                1e-6);
    }
  }
}

// r(v) = .9 - .2 v: what is listed is exact for the r of its own speeds, since the shooting
// equations hold; and a constant r that happens to be that of the orbit's speed has the same orbit.
TEST(Patterns, RestitutionThatDependsOnTheSpeed) {
  System system = support::forced_oscillator(1.0, 0.05, 0.1, 0.8, 2.0, 1.0);
  system.stops[0].impact().restitution = Restitution(std::vector<double>{0.9, 0.2});
  FinderOptions options = searching(1, 1);
  options.keep_virtual = true;
  const FoundOrbits found = find_orbits(system, {}, options);
  ASSERT_FALSE(found.orbits.empty());
  for (const Orbit& orbit : found.orbits) {
    EXPECT_LE(orbit.residual, 1e-11);
    System same = system;
    same.stops[0].impact().restitution =
        Restitution(system.stops[0].restitution().at(orbit.impacts[0].speed));
    bool there = false;
    for (const Orbit& other : find_orbits(same, {}, options).orbits)
      there = there || (std::abs(other.impacts[0].phase - orbit.impacts[0].phase) < 1e-9 &&
                        std::abs(other.impacts[0].speed - orbit.impacts[0].speed) < 1e-9);
    EXPECT_TRUE(there);
  }
}

// x'' + W^2 x = cos(W t), undamped in resonance: the phases alone do not do, nor does the closed
// form, and rough guesses at the shooting equations stand in. Over a period P = 2 pi/W from phase
// theta the free flow is the identity and the forcing adds P sin(theta)/(2 W) to x, P cos(theta)/2
// to x'. So an orbit with one impact, x' from v to -r v, has sin(theta) = 0 and v = P cos(theta)/(2
// (1 + r)).
TEST(Patterns, RoughGuessesWhereAModeRepeatsByItself) {
  const double frequency = 1.6, restitution = 0.7;
  const System system =
      support::forced_oscillator(frequency, 0.0, 0.1, restitution, frequency, 1.0);
  FinderOptions options = searching(1, 1);
  options.keep_virtual = true;
  const FoundOrbits found = find_orbits(system, {}, options);
  ASSERT_FALSE(found.notes.empty());
  EXPECT_NE(found.notes[0].find("mode 1 repeats by itself"), std::string::npos) << found.notes[0];
  ASSERT_EQ(found.orbits.size(), 2u);
  const double speed = kTurn / frequency / (2.0 * (1.0 + restitution));
  for (const Orbit& orbit : found.orbits) {
    const OrbitImpact& impact = orbit.impacts[0];
    EXPECT_NEAR(std::abs(impact.speed), speed, 1e-10);
    const double phase = impact.speed > 0.0 ? 0.0 : std::numbers::pi;
    EXPECT_NEAR(std::remainder(impact.phase - phase, kTurn), 0.0, 1e-10);
  }
  EXPECT_LT(found.orbits[0].impacts[0].speed * found.orbits[1].impacts[0].speed, 0.0);
}

TEST(Patterns, ASearchInVainSaysWhatWasTried) {
  const System system = support::forced_oscillator(1.0, 0.05, 50.0, 0.8, 2.0, 1.0);
  FinderOptions exactly = searching(1, 2);
  exactly.from_closed_form = true;
  const FoundOrbits two = find_orbits(system, {}, exactly);
  EXPECT_TRUE(two.orbits.empty());
  EXPECT_EQ(two.tried, "0 starts from the closed form of two impacts on 1 pair of stops");
  const FoundOrbits found = find_orbits(system, {}, searching(1, 2));
  EXPECT_TRUE(found.orbits.empty());
  EXPECT_NE(found.tried.find("random starts on 1 sequence of stops"), std::string::npos)
      << found.tried;
  EXPECT_NE(found.tried.find("global minimisations"), std::string::npos) << found.tried;
}

}  // namespace
}  // namespace graze
