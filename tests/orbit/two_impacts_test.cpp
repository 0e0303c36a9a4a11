// Every (p, 2) solution in closed form, against a grid over the torus of both phases, which knows
// nothing of it: Newton's method on the phase problem from each of its points.
#include "graze/orbit/closed_form/detail/two_impacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "graze/assembly/assembly.hpp"
#include "graze/base/angle.hpp"
#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/orbit/problem/orbit_identity.hpp"
#include "graze/orbit/search/detail/pair_search.hpp"
#include "graze/orbit/search/finder.hpp"
#include "support/random_system.hpp"

namespace graze {
namespace {

using Solutions = std::vector<PhaseSolution>;

// Damped modes and a stop or two on random places.
System random_structure(support::Dice& dice, int modes, int stops) {
  System system{Vector(modes), NaturalModes{Vector(modes)}, {}};
  const double frequency = dice.uniform(0.5, 3.0);
  for (int j = 0; j < modes; ++j) {
    system.omega[j] = dice.uniform(0.5, 8.0);
    system.modal().delta[j] = dice.uniform(0.01, 0.3) * system.omega[j];
  }
  system.modal().forcing =
      HarmonicForcing{frequency, dice.uniform(0.0, 6.0), dice.vector(modes, -1.0, 1.0)};
  for (int i = 0; i < stops; ++i) {
    const Vector row = dice.vector(modes, -1.0, 1.0);
    system.stops.push_back(
        {row, dice.uniform(0.0, 0.3), ImpactLaw{momentum_direction(row), dice.uniform(0.0, 1.0)}});
  }
  return system;
}

// Whether it is the same motion as one of the list.
bool has(const Solutions& list, const PhaseSolution& solution, double speed) {
  for (const PhaseSolution& known : list)
    if (same_orbit(outline(known), outline(solution), speed)) return true;
  return false;
}

// Both impacts at the phases of a grid; those that repeat a shorter orbit are left out.
Solutions on_a_grid(const PhaseProblem& problem, const MotionScale& scale) {
  constexpr int kFirst = 24, kSecond = 96;
  const int period = problem.response().period();
  Solutions found;
  for (int i = 0; i < kFirst; ++i)
    for (int j = 0; j < kSecond; ++j) {
      const double theta = kTurn * (i + 0.5) / kFirst;
      const Vector start{{theta, theta + kTurn * period * (j + 0.5) / kSecond}};
      const auto solution = solution_near(problem, scale.length, start);
      if (solution && !repeated_pattern(outline(*solution)) && !has(found, *solution, scale.speed))
        found.push_back(*solution);
    }
  return found;
}

// Both stops are hit at one phase, which is one impact on two stops.
bool is_at_once(const PhaseSolution& solution, int period) {
  return std::abs(std::remainder(solution.phases[1] - solution.phases[0], kTurn * period)) < 1e-6;
}

Solutions in_closed_form(const System& system, const PeriodicResponse& response,
                         const TwoImpacts& form, const std::vector<int>& stops) {
  const MotionScale scale = motion_scale(system);
  const PhaseJudge judge(system, response, scale, true);
  return solve_pairs(form, response, judge, {stops}, scale, 1, {}).solutions;
}

void expect_all_of_the_grid(const System& system, int period, const std::string& which) {
  const PeriodicResponseAnswer response = periodic_response(system, period);
  ASSERT_TRUE(response.response) << response.why_not;
  const TwoImpactsAnswer form = two_impacts(*response.response);
  ASSERT_TRUE(form.form) << form.why_not;
  const MotionScale scale = motion_scale(system);
  const int stops = static_cast<int>(system.stops.size());
  for (int first = 0; first < stops; ++first)
    for (int second = first; second < stops; ++second) {
      ASSERT_TRUE(form.form->holds(first, second));
      const PhaseProblem problem(*response.response, {first, second}, scale.speed);
      const Solutions all = in_closed_form(system, *response.response, *form.form, {first, second});
      for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_FALSE(
            has({all.begin() + static_cast<std::ptrdiff_t>(i) + 1, all.end()}, all[i], scale.speed))
            << which << ": twice";
      for (const PhaseSolution& solution : on_a_grid(problem, scale)) {
        if (is_at_once(solution, period)) continue;
        EXPECT_TRUE(has(all, solution, scale.speed))
            << which << ", stops " << first << " " << second << ": missed "
            << solution.phases.transpose();
      }
    }
}

TEST(TwoImpacts, AreAllThatAGridFinds) {
  support::Dice dice(2024);
  for (int n = 0; n < 24; ++n) {
    const System system = random_structure(dice, 1 + n % 3, 1 + n % 2);
    expect_all_of_the_grid(system, 1 + n / 8, "system " + std::to_string(n));
  }
}

// At gap 0 both contacts are on lines through the origin of z, and every zero is a double one of
// |z|^2 = 1. (Of one mode they would be one stop.)
TEST(TwoImpacts, AreAllThereAtGapsOfZero) {
  support::Dice dice(7);
  for (int n = 0; n < 6; ++n) {
    System system = random_structure(dice, 2 + n % 2, 2);
    for (Stop& stop : system.stops) stop.gap = 0.0;
    expect_all_of_the_grid(system, 1 + n / 3, "system " + std::to_string(n));
  }
}

// A body without spring or damper between walls: it flies straight, crosses the distance 2 a in
// half a period, and loses at each wall what the force gives it. With the phases of the impacts
// half a turn apart contact and restitution r give speed and phase in closed form. In
// mass-normalised units x'' = F cos t with walls at +-a: x' = V + F sin t between the impacts at t0
// and t0 + pi.
TEST(TwoImpacts, OfABodyBetweenWallsAreThoseOfTheTextbook) {
  const double a = 1.3, r = 0.6, F = 1.0;
  System system = support::forced_oscillator(1e-3, 1e-4, a, r, 1.0, F);
  system.stops.push_back({-Vector::Ones(1), a, ImpactLaw{-Vector::Ones(1), r}});
  const PeriodicResponseAnswer response = periodic_response(system, 1);
  ASSERT_TRUE(response.response) << response.why_not;
  const TwoImpactsAnswer form = two_impacts(*response.response);
  ASSERT_TRUE(form.form) << form.why_not;
  // From the wall at +a at t0, where it arrives with v: x'(t0+) = -r v, and at t0 + pi it meets -a
  // with -v, so that -v = -r v - 2 F sin t0 and -2 a = -(r v + F sin t0) pi + 2 F cos t0.
  // v = 2 F sin t0/(1 - r): 2 a = pi F sin t0 (1 + r)/(1 - r) - 2 F cos t0.
  const double along = std::numbers::pi * F * (1.0 + r) / (1.0 - r), across = 2.0 * F;
  const double size = std::hypot(along, across), lag = std::atan2(-across, along);
  const double shift = std::asin(2.0 * a / size);
  const Solutions all = in_closed_form(system, *response.response, *form.form, {0, 1});
  for (const double t0 : {shift - lag, std::numbers::pi - shift - lag}) {
    const double v = 2.0 * F * std::sin(t0) / (1.0 - r);
    int found = 0;
    for (const PhaseSolution& solution : all) {
      const Eigen::Index first = solution.pattern.stops[0] == 0 ? 0 : 1;
      const Vector& phases = solution.phases;
      if (std::abs(std::remainder(phases[first] - t0, kTurn)) > 1e-3 ||
          std::abs(phases[1] - phases[0] - std::numbers::pi) > 1e-10)
        continue;
      ++found;
      EXPECT_NEAR(solution.speeds[0], v, 1e-3);
      EXPECT_NEAR(solution.speeds[1], v, 1e-3);
    }
    EXPECT_EQ(found, 1) << t0;
  }
}

// Mirrored stops: at half the orbit, and beside it, all that the grid finds.
TEST(TwoImpacts, BetweenMirroredStopsAreAllThere) {
  support::Dice dice(5);
  for (int n = 0; n < 12; ++n) {
    System system = random_structure(dice, 1 + n % 2, 1);
    Stop opposite = system.stops[0];
    opposite.row *= -1.0;
    opposite.law = ImpactLaw{momentum_direction(opposite.row), opposite.restitution().at(0.0)};
    // Nearly mirrored ones, too.
    if (n % 3 == 2) opposite.gap += std::pow(10.0, -3 - n);
    system.stops.push_back(opposite);
    expect_all_of_the_grid(system, 1 + n / 6, "system " + std::to_string(n));
  }
}

// A structure of two modes that is its own mirror image, under a force that is, too: its stops see
// the same of the forced motion.
struct Mirrored {
  Vector omega, ratio;
  double load, frequency;
  Vector row;
  double gap, restitution;
  int period;
};

System structure_of(const Mirrored& its) {
  System system{its.omega, NaturalModes{its.ratio.cwiseProduct(its.omega)}, {}};
  system.modal().forcing = HarmonicForcing{its.frequency, 0.0, Vector{{its.load, 0.0}}};
  for (const double side : {1.0, -1.0}) {
    const Vector row{{its.row[0], side * its.row[1]}};
    system.stops.push_back({row, its.gap, ImpactLaw{momentum_direction(row), its.restitution}});
  }
  return system;
}

// Over an even number of periods both contacts are one equation at half the orbit. Of the first two
// the symmetric orbits lie in minima where |n| stays above |E|.
TEST(TwoImpacts, OfAStructureThatMirrorsItselfAreAllThere) {
  const Mirrored list[] = {{Vector{{2.8915, 5.2938}}, Vector{{0.1, 0.01}}, -0.847, 3.9726,
                            Vector{{0.449, 0.239}}, 0.1, 0.95, 2},
                           {Vector{{3.3576, 4.268}}, Vector{{0.1, 0.01}}, 0.438, 3.7543,
                            Vector{{-0.915, 0.432}}, 0.1, 0.3, 2},
                           {Vector{{1.7438, 0.5644}}, Vector{{0.05, 0.1}}, -0.321, 2.5429,
                            Vector{{-0.729, -0.535}}, 0.1, 0.3, 1}};
  for (const Mirrored& its : list)
    expect_all_of_the_grid(structure_of(its), its.period,
                           "frequency " + std::to_string(its.frequency));
  support::Dice dice(31);
  for (int n = 0; n < 16; ++n) {
    const Vector omega{{dice.uniform(0.5, 6.0), dice.uniform(0.5, 6.0)}};
    const Mirrored its{omega,
                       dice.vector(2, 0.01, 0.2),
                       dice.uniform(-1.0, 1.0),
                       dice.uniform(0.5, 4.0),
                       dice.vector(2, -1.0, 1.0),
                       dice.uniform(0.0, 0.3),
                       dice.uniform(0.0, 1.0),
                       1 + n % 4};
    expect_all_of_the_grid(structure_of(its), its.period, "system " + std::to_string(n));
  }
}

// A solution of the equations in which a flight goes backwards is a motion through no impacts
// (found by experiment: between the two impacts lie 6.475 and -.192 rad, and the sum of the
// responses to both misses the second stop by 3 %).
TEST(TwoImpacts, OfASearchComeInTheirOrderToo) {
  const Mirrored its{Vector{{1.7438, 0.5644}},
                     Vector{{0.05, 0.1}},
                     -0.321,
                     2.5429,
                     Vector{{-0.729, -0.535}},
                     0.1,
                     0.3,
                     1};
  FinderOptions options;
  options.impacts = 2;
  options.from_simulation = options.from_closed_form = false;
  options.keep_virtual = true;
  const FoundOrbits found = find_orbits(structure_of(its), {}, options);
  EXPECT_GE(found.orbits.size(), 4u);
  for (const Orbit& orbit : found.orbits) {
    const double between = orbit.points()[1].theta - orbit.points()[0].theta;
    EXPECT_TRUE(between > 0.0 && between < kTurn) << between;
  }
}

TEST(TwoImpacts, AreLeftToTheSearchWhereRestitutionDependsOnSpeedOrNothingIsLost) {
  System lossless = support::forced_oscillator(1.0, 0.0, 0.5, 1.0, 2.3, 1.0);
  const PeriodicResponseAnswer response = periodic_response(lossless, 1);
  ASSERT_TRUE(response.response);
  EXPECT_FALSE(two_impacts(*response.response).form->holds(0, 0));

  System quick = support::forced_oscillator(1.0, 0.01, 0.5, 0.8, 1e-4, 1.0);
  const PeriodicResponseAnswer slow = periodic_response(quick, 1);
  ASSERT_TRUE(slow.response);
  EXPECT_FALSE(two_impacts(*slow.response).form);
  EXPECT_NE(two_impacts(*slow.response).why_not.find("periods"), std::string::npos);
}

// The search by random starts finds nothing else, and the finder lists each orbit once.
TEST(TwoImpacts, ListTheOrbitsOfTheSearchAndPerhapsMore) {
  support::Dice dice(11);
  int orbits = 0;
  for (int n = 0; n < 24; ++n) {
    const System system = random_structure(dice, 2, 2);
    FinderOptions options;
    options.impacts = 2;
    options.period = 1 + n % 2;
    options.from_simulation = false;
    options.keep_virtual = n % 3 == 0;
    FinderOptions by_search = options;
    by_search.from_closed_form = false;
    const FoundOrbits found = find_orbits(system, {}, options);
    const double speed = motion_scale(system).speed;
    for (const Orbit& orbit : find_orbits(system, {}, by_search).orbits) {
      ++orbits;
      int same = 0;
      for (const Orbit& other : found.orbits) same += same_orbit(orbit, other, speed) ? 1 : 0;
      EXPECT_EQ(same, 1) << n;
    }
  }
  EXPECT_GT(orbits, 20);
}

}  // namespace
}  // namespace graze
