// P and G rows of the catalogue of hard cases. Expected digits: closed forms evaluated in 40 to 60
// digits by others, and arXiv:2510.16218 for P2.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/orbit/search/finder.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

// The (p, 1) solution of the closed form with the larger approach speed.
Orbit faster_closed_form_orbit(const System& system, int period = 1) {
  const ClosedFormAnswer answer = closed_form(system, 0, period);
  EXPECT_TRUE(answer.form) << answer.why_not;
  const ShootingProblem problem({period, {0}}, motion_scale(system));
  std::vector<Orbit> orbits;
  for (const ImpactPoint& point : answer.form->solutions(system.stops[0].gap))
    orbits.push_back(make_orbit(system, problem, problem.pack(system, {point})));
  EXPECT_EQ(orbits.size(), 2u);
  return orbits[0].impacts[0].speed > orbits[1].impacts[0].speed ? orbits[0] : orbits[1];
}

std::vector<Orbit> all_solutions(const Scene& scene) {
  FinderOptions options;
  options.impacts = 1;
  options.keep_virtual = true;
  const System system = assemble(scene);
  return find_orbits(system, initial_state(scene, system), options).orbits;
}

const Orbit* nearest_phase(const std::vector<Orbit>& orbits, double phase) {
  const Orbit* nearest = nullptr;
  for (const Orbit& orbit : orbits)
    if (!nearest ||
        std::abs(orbit.impacts[0].phase - phase) < std::abs(nearest->impacts[0].phase - phase))
      nearest = &orbit;
  return nearest;
}

double distance_to_multiplier(const Orbit& orbit, Complex value) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Eigenvalue& m : orbit.multipliers)
    smallest = std::min(smallest, std::abs(m.value - value));
  return smallest;
}

void expect_orbit(const std::string& name, double speed, double phase,
                  const std::vector<Complex>& multipliers) {
  SCOPED_TRACE(name);
  const std::vector<Orbit> orbits = all_solutions(support::reference_scene("orbits/" + name));
  ASSERT_EQ(orbits.size(), 2u);
  const Orbit& orbit = *nearest_phase(orbits, phase);
  EXPECT_NEAR(orbit.impacts[0].phase, phase, 1e-12);
  EXPECT_NEAR(orbit.impacts[0].speed, speed, 1e-12);
  for (const Complex& m : multipliers) EXPECT_LE(distance_to_multiplier(orbit, m), 1e-10) << m;
}

TEST(HardCases, P1ClosedFormOfOneImpact) {
  expect_orbit("sdof_2_8", 0.33448213190105355, 2.98554359150952538,
               {-2.646309419411, -0.1932341572841});
  expect_orbit("sdof_1_6", 2.75870902685428, 0.53869685675624961,
               {{0.3994309096563, 0.5221143252879}, {0.3994309096563, -0.5221143252879}});
  expect_orbit("three_modes_2_1", 0.399050213948171, 2.49460897030242, {});
  expect_orbit("three_modes_2_5", 0.875886678164368, 1.88147086806440, {});
}

TEST(HardCases, P1SpectralRadiusOfThreeModes) {
  const auto orbits = all_solutions(support::reference_scene("orbits/three_modes_2_1"));
  const Orbit& orbit = *nearest_phase(orbits, 2.49460897030242);
  EXPECT_NEAR(std::abs(orbit.multipliers.front().value), 0.733735319384, 1e-10);
  EXPECT_EQ(orbit.stable, true);
  EXPECT_TRUE(orbit.admissible);
}

TEST(HardCases, P1PenetratingSolutionIsNoOrbit) {
  const Scene scene = support::reference_scene("orbits/three_modes_2_5");
  const std::vector<Orbit> solutions = all_solutions(scene);
  const Orbit& orbit = *nearest_phase(solutions, 1.88147086806440);
  EXPECT_FALSE(orbit.admissible);
  ASSERT_TRUE(orbit.clearance);
  // Of tests/reference/closed_form_clearances.csv; the catalogue prints its first digits, .144465.
  EXPECT_NEAR(*orbit.clearance, -0.14446542041852315, 1e-12);

  const System system = assemble(scene);
  FinderOptions options;
  options.impacts = 1;
  const FoundOrbits found = find_orbits(system, support::rest(system), options);
  EXPECT_TRUE(found.orbits.empty());
  EXPECT_EQ(found.inadmissible, 2);
}

// u'' + .04 u' + u = A cos(w t), u <= 1, r = .9.
System published(double frequency, double amplitude) {
  return support::forced_oscillator(1.0, 0.02, 1.0, 0.9, frequency, amplitude);
}

TEST(HardCases, P2PublishedFlip) {
  const double amplitude = 0.347533397412, half_digit = 0.5e-12;
  const Orbit orbit = faster_closed_form_orbit(published(0.81, amplitude), 2);
  // The printed amplitude is rounded, and the speed with it.
  const double by_amplitude =
      std::abs(faster_closed_form_orbit(published(0.81, amplitude + 1e-9), 2).impacts[0].speed -
               orbit.impacts[0].speed) /
      1e-9;
  EXPECT_NEAR(orbit.impacts[0].speed, 0.0653039433369, 1e-13 + by_amplitude * half_digit);
  // The smaller multiplier is det M/(-1), which the amplitude does not enter: all digits hold.
  // Near the flip the sum of both moves like 1/v^2 with the amplitude.
  const double speed = orbit.impacts[0].speed;
  EXPECT_LE(distance_to_multiplier(orbit, -1.0), half_digit * by_amplitude * 4.0 / speed);
  EXPECT_LE(distance_to_multiplier(orbit, -0.435490392782),
            half_digit * by_amplitude * 4.0 / speed);
  EXPECT_TRUE(orbit.admissible);
}

TEST(HardCases, P2PublishedFold) {
  // |kappa| is proportional to the amplitude; the fold is where it equals the stop's distance.
  const ClosedFormAnswer answer = closed_form(published(0.799, 1.0), 0, 2);
  ASSERT_TRUE(answer.form);
  const double amplitude = 1.0 / std::abs(answer.form->kappa);
  EXPECT_NEAR(amplitude, 0.3628362019809, 1e-13);
  const System system = published(0.799, amplitude);
  const ClosedFormAnswer at_fold = closed_form(system, 0, 2);
  ASSERT_TRUE(at_fold.form);
  const ImpactPoint point = at_fold.form->solutions(std::abs(at_fold.form->kappa)).front();
  EXPECT_NEAR(point.before.qdot[0], 0.1240873448523, 1e-12);
  const ImpactPattern pattern{2, {0}};
  const Matrix m = monodromy_matrix(system, pattern, {point});
  EXPECT_NEAR((m - Matrix::Identity(2, 2)).determinant(), 0.0, 1e-11);
  EXPECT_NEAR(m.trace(), 1.0 + 0.431785672133, 1e-11);
}

TEST(HardCases, P2FoundByTheFinder) {
  const System system = published(0.81, 0.347533397412);
  FinderOptions options;
  options.period = 2;
  options.impacts = 1;
  options.from_simulation = false;
  const FoundOrbits found = find_orbits(system, support::rest(system), options);
  ASSERT_FALSE(found.orbits.empty());
  double smallest = 1.0;
  for (const Orbit& orbit : found.orbits) {
    EXPECT_EQ(orbit.period, 2);
    smallest = std::min(smallest, std::abs(orbit.impacts[0].speed - 0.0653039433369));
  }
  EXPECT_LE(smallest, 1e-10);
}

// x'' + .1 x' + x = F cos(1.6 t), a = .5, r = .8, at F = F_g (1 - 10^-k).
System grazing_oscillator(double relative_force) {
  const double grazing = 0.784091831356506353;
  return support::forced_oscillator(1.0, 0.05, 0.5, 0.8, 1.6, grazing * relative_force);
}

void expect_low_speed_branch(int k, double speed, double trace) {
  const System system = grazing_oscillator(1.0 - std::pow(10.0, -k));
  // Storing 1.6 and .1 as doubles moves the speed by 2e-8 at k = 8.
  const double relative = std::max(1e-10, 40.0 * 2.2e-16 * std::pow(10.0, k));
  const ClosedFormAnswer answer = closed_form(system, 0, 1);
  ASSERT_TRUE(answer.form);
  double smallest = std::numeric_limits<double>::infinity();
  for (const ImpactPoint& point : answer.form->solutions(0.5)) {
    const double v = point.before.qdot[0];
    if (!(v > 0.0 && v < smallest)) continue;
    smallest = v;
    const Matrix m = monodromy_matrix(system, {1, {0}}, {point});
    if (v < 1.0) {
      EXPECT_NEAR(std::abs(m.trace()) / trace, 1.0, relative) << "k = " << k;
    }
  }
  EXPECT_NEAR(smallest / speed, 1.0, relative) << "k = " << k;
}

TEST(HardCases, G2LowSpeedBranchIntoGrazing) {
  expect_low_speed_branch(1, 0.137511747016, 10.014975674);
  expect_low_speed_branch(4, 1.36417229381e-4, 9777.742627);
  expect_low_speed_branch(8, 1.36416259507e-8, 97774968.02);
}

TEST(HardCases, G2UpperBranchAndFold) {
  const Orbit upper = faster_closed_form_orbit(grazing_oscillator(1.0 - 1e-8));
  EXPECT_NEAR(upper.impacts[0].speed, 2.38867641229661919, 1e-10);
  ASSERT_EQ(upper.multipliers.size(), 2u);
  EXPECT_NEAR(std::abs(upper.multipliers[0].value), 0.657379966427, 1e-10);

  const ClosedFormAnswer answer = closed_form(grazing_oscillator(1.0), 0, 1);
  ASSERT_TRUE(answer.form);
  const double relative = 0.5 / std::abs(answer.form->kappa);
  EXPECT_NEAR(relative, 0.352831175746127748, 1e-14);
  const System at_fold = grazing_oscillator(relative);
  const ClosedFormAnswer there = closed_form(at_fold, 0, 1);
  ASSERT_TRUE(there.form);
  const ImpactPoint point = there.form->solutions(std::abs(there.form->kappa)).front();
  EXPECT_NEAR(point.before.qdot[0], 1.19433821296912, 1e-12);
  const Matrix m = monodromy_matrix(at_fold, {1, {0}}, {point});
  EXPECT_NEAR(m.trace(), 1.43214842026, 1e-10);
  EXPECT_NEAR(m.determinant(), 0.43214842026, 1e-10);
}

TEST(HardCases, G3SaltationDeterminantAndFold) {
  for (const support::TableRow& row : support::read_table("closed_form_orbits.csv")) {
    SCOPED_TRACE(row.at("case") + " at phase " + row.at("phase"));
    const Scene scene = support::reference_scene("orbits/" + row.at("case"));
    const System system = assemble(scene);
    const int period = std::stoi(row.at("period"));
    const ClosedFormAnswer answer = closed_form(system, 0, period);
    ASSERT_TRUE(answer.form);
    for (const ImpactPoint& point : answer.form->solutions(system.stops[0].gap)) {
      const Matrix m = monodromy_matrix(system, {period, {0}}, {point});
      const double r = system.stops[0].restitution().at_rest();
      const double expected =
          r * r * std::exp(-2.0 * period * system.period() * system.delta().sum());
      // A determinant loses the products of the matrix's entries to rounding.
      const Matrix size = m.cwiseAbs();
      EXPECT_NEAR(m.determinant() / expected, 1.0,
                  1e-15 * std::pow(size.norm(), 2) / expected + 1e-12);
    }
  }
}

TEST(HardCases, G3MultiplierIsOneAtTheClosedFormFold) {
  for (const support::TableRow& row : support::read_table("closed_form_folds.csv")) {
    SCOPED_TRACE(row.at("case") + " " + row.at("parameter") + " " + row.at("value"));
    const Scene scene = support::reference_scene(
        "orbits/" + row.at("case"), {row.at("parameter") + "=" + row.at("value").substr(0, 18)});
    const System system = assemble(scene);
    const ClosedFormAnswer answer = closed_form(system, 0, 1);
    ASSERT_TRUE(answer.form);
    const double kappa = std::abs(answer.form->kappa);
    EXPECT_NEAR(kappa / system.stops[0].gap, 1.0, 1e-11);
    const ImpactPoint point = answer.form->solutions(kappa).front();
    EXPECT_NEAR(std::remainder(point.theta - support::number(row, "phase"), kTurn), 0.0, 1e-11);
    EXPECT_NEAR(system.stops[0].row.dot(point.before.qdot) / support::number(row, "speed"), 1.0,
                1e-10);
    const Matrix m = monodromy_matrix(system, {1, {0}}, {point});
    double smallest = 1.0;
    for (const Eigenvalue& multiplier : eigenvalues(m))
      smallest = std::min(smallest, std::abs(multiplier.value - 1.0));
    EXPECT_LE(smallest, 1e-9);
  }
}

// x'' + .1 x' + x = A cos t, stop 1, r = .8: the impact example of COCO.
TEST(HardCases, P3FoldBesideGrazing) {
  const ClosedFormAnswer answer =
      closed_form(support::forced_oscillator(1.0, 0.05, 1.0, 0.8, 1.0, 1.0), 0, 1);
  ASSERT_TRUE(answer.form);
  const double fold = 1.0 / std::abs(answer.form->kappa);
  EXPECT_NEAR(fold, 0.0999707536283, 1e-13);
  const ClosedFormAnswer there =
      closed_form(support::forced_oscillator(1.0, 0.05, 1.0, 0.8, 1.0, fold), 0, 1);
  ASSERT_TRUE(there.form);
  EXPECT_NEAR(there.form->solutions(std::abs(there.form->kappa)).front().before.qdot[0],
              0.00411153064, 1e-11);
}

}  // namespace
}  // namespace graze
