// Newton for good guesses, Levenberg-Marquardt (Ceres) for poor ones; the closed form is the judge.
#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/base/angle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/search/detail/rough_guess.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

System reference_system(const std::string& name) {
  return assemble(support::reference_scene("orbits/" + name));
}

// Distance of a solution to the nearer of the two of the closed form, in phase and relative speed.
double distance_to_closed_form(const System& system, const ImpactPoint& point) {
  const ClosedFormAnswer answer = closed_form(system, 0, 1);
  double nearest = std::numeric_limits<double>::infinity();
  for (const ImpactPoint& exact : answer.form->solutions(system.stops[0].gap)) {
    const double speed = system.stops[0].row.dot(exact.before.qdot);
    const double other = system.stops[0].row.dot(point.before.qdot);
    nearest = std::min(nearest, std::abs(std::remainder(point.theta - exact.theta, kTurn)) +
                                    std::abs(other / speed - 1.0));
  }
  return nearest;
}

// Guesses: twelve phases, speeds of the forced motion's size.
std::vector<ImpactPoint> grid_of_guesses(const System& system) {
  std::vector<ImpactPoint> guesses;
  const double unit = motion_scale(system).length * system.forcing()->frequency;
  for (int i = 0; i < 12; ++i)
    for (const double speed : {0.5 * unit, unit, 2.0 * unit})
      guesses.push_back(rough_guess(system, 0, kTurn * i / 12.0, speed));
  return guesses;
}

TEST(Solve, RoughGuessMeetsTheStopAtItsSpeed) {
  const System system = reference_system("beam_n4_40");
  const ImpactPoint guess = rough_guess(system, 0, 1.3, 0.4);
  EXPECT_EQ(guess.theta, 1.3);
  EXPECT_NEAR(system.stops[0].row.dot(guess.before.q), system.stops[0].gap, 1e-15);
  EXPECT_NEAR(system.stops[0].row.dot(guess.before.qdot), 0.4, 1e-14);
}

TEST(Solve, SeekBringsInEveryRoughGuess) {
  for (const char* name :
       {"sdof_2_8", "sdof_1_6", "three_modes_2_1", "beam_n2_40", "beam_n4_40", "beam_n4_47"}) {
    SCOPED_TRACE(name);
    const System system = reference_system(name);
    const ShootingProblem problem({1, {0}}, motion_scale(system));
    for (const ImpactPoint& guess : grid_of_guesses(system)) {
      const auto solution = seek(problem, system, problem.pack(system, {guess}));
      ASSERT_TRUE(solution) << guess.theta;
      EXPECT_LE(solution->residual, kShootingTolerance);
      EXPECT_LE(distance_to_closed_form(system, problem.unpack(system, solution->x).front()),
                1e-10);
    }
  }
}

// A set on which plain Newton fails and Levenberg-Marquardt does not: a gap that is |kappa| of the
// closed form less a part of 1e-10, where both solutions nearly meet and Newton, even where it
// converges, only halves its error. All 36 guesses of the grid, for each of these four systems.
TEST(Solve, SeekSucceedsBesideAFoldWhereNewtonFails) {
  for (const char* name : {"sdof_2_8", "sdof_1_6", "beam_n2_40", "beam_n4_40"}) {
    SCOPED_TRACE(name);
    System system = reference_system(name);
    const double fold = std::abs(closed_form(system, 0, 1).form->kappa);
    system.stops[0].gap = fold * (1.0 - 1e-10);
    const ShootingProblem problem({1, {0}}, motion_scale(system));
    for (const ImpactPoint& guess : grid_of_guesses(system)) {
      EXPECT_FALSE(newton(problem, system, problem.pack(system, {guess}))) << guess.theta;
      const auto solution = seek(problem, system, problem.pack(system, {guess}));
      ASSERT_TRUE(solution) << guess.theta;
      // The smallest singular value of the equations is 2e-7 here: some roundings of 2e-15, of the
      // solution and of the closed form, become some 1e-8. What solve.hpp promises is 1e-7.
      EXPECT_LE(distance_to_closed_form(system, problem.unpack(system, solution->x).front()),
                kShootingAccuracy);
    }
  }
}

// Where there is no solution, least squares still says that it converged; the residual does not.
TEST(Solve, NothingJustPastAFold) {
  for (const char* name : {"sdof_1_6", "beam_n2_40", "beam_n4_40"}) {
    SCOPED_TRACE(name);
    System system = reference_system(name);
    const double fold = std::abs(closed_form(system, 0, 1).form->kappa);
    for (const double past : {1e-2, 1e-4, 1e-6, 1e-8, 1e-9}) {
      system.stops[0].gap = fold * (1.0 + past);
      const ShootingProblem problem({1, {0}}, motion_scale(system));
      for (const ImpactPoint& guess : grid_of_guesses(system)) {
        EXPECT_FALSE(newton(problem, system, problem.pack(system, {guess}))) << past;
        EXPECT_FALSE(seek(problem, system, problem.pack(system, {guess}))) << past;
      }
    }
  }
}

// A second such set: two impacts in two periods of x'' + .1 x' + x = cos(2.8 t), stop at 0, r = .8
// (scene 04). First phase kTurn i/12, second later by 2 kTurn j/7, both speeds 2^k/4 times the
// forced motion's.
TEST(Solve, SeekSucceedsForTwoImpactsWhereNewtonFails) {
  const System system = assemble(support::shipped_scene("04_impact_oscillator"));
  const MotionScale scale = motion_scale(system);
  const ShootingProblem problem({2, {0, 0}}, scale);
  const double unit = scale.length * system.forcing()->frequency;
  const int guesses[][3] = {{2, 2, 0}, {2, 2, 2}, {3, 2, 0}, {3, 2, 2}, {4, 1, 2},
                            {4, 2, 2}, {5, 1, 2}, {8, 3, 1}, {8, 4, 0}};
  for (const auto& [i, j, k] : guesses) {
    const double theta = kTurn * i / 12.0, speed = 0.25 * unit * (1 << k);
    const Vector x = problem.pack(system, {rough_guess(system, 0, theta, speed),
                                   rough_guess(system, 0, theta + 2.0 * kTurn * j / 7.0, speed)});
    EXPECT_FALSE(newton(problem, system, x)) << i << " " << j << " " << k;
    const auto solution = seek(problem, system, x);
    ASSERT_TRUE(solution) << i << " " << j << " " << k;
    EXPECT_LE(problem.residual(system, solution->x).cwiseAbs().maxCoeff(), kShootingTolerance);
  }
}

}  // namespace
}  // namespace graze
