// The phase problem: its solutions solve the shooting equations, its derivatives are right, for one
// impact it is the closed form, and it says where it does not hold.
#include "graze/orbit/closed_form/detail/phase_problem.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/base/angle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graze/contact/detail/impulse.hpp"
#include "graze/flow/exact/detail/exact_flow.hpp"
#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/problem/detail/solve.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// Every kind of mode at once: oscillatory, overdamped, critically damped, nearly resonant with the
// forcing, a soft one; with a load and two stops.
System many_kinds() {
  System system;
  system.omega = (Vector(5) << 1.0, 3.0, 4.0, 2.3, 0.4).finished();
  system.modal().delta = (Vector(5) << 0.05, 3.5, 4.0, 1e-3, 0.02).finished();
  system.modal().forcing =
      HarmonicForcing{2.3, 0.0, (Vector(5) << 1.0, -0.5, 0.3, 0.01, 0.2).finished()};
  system.modal().load = (Vector(5) << 0.1, 0.2, -0.1, 0.05, 0.02).finished();
  const Vector above = (Vector(5) << 1.0, -0.5, 0.7, 0.3, 0.4).finished();
  const Vector below = (Vector(5) << -0.6, 0.9, 0.2, -0.3, -0.5).finished();
  system.stops.push_back({above, 0.3, ImpactLaw{above / above.squaredNorm(), 0.8}});
  system.stops.push_back({below, 0.2, ImpactLaw{below / below.squaredNorm(), 0.6}});
  return system;
}

// Whatever the phases, the motion repeats: all matching equations hold, and the contact equations
// leave what `defect` says. Both are computed in other ways by ShootingProblem.
void expect_repetition(const System& system) {
  const MotionScale scale = motion_scale(system);
  for (const int period : {1, 2, 3}) {
    const PeriodicResponseAnswer answer = periodic_response(system, period);
    ASSERT_TRUE(answer.response) << answer.why_not;
    for (const std::vector<int>& stops :
         {std::vector<int>{0}, {1}, {0, 0}, {0, 1}, {0, 1, 1}, {1, 0, 0, 1}}) {
      const PhaseProblem phases(*answer.response, stops, 1.0);
      Vector theta(static_cast<Eigen::Index>(stops.size()));
      for (Eigen::Index i = 0; i < theta.size(); ++i)
        theta[i] = 0.7 + 1.3 * static_cast<double>(i) + 0.1 * static_cast<double>(i * i);
      const ShootingProblem shooting({period, stops}, scale);
      const Vector r = shooting.residual(system, shooting.pack(system, phases.points(theta)));
      const Vector contact = phases.defect(theta);
      const Eigen::Index block = 2 * system.modes() + 1;
      // Tens of roundings, enlarged by the inverse of I - E: its smallest singular value is that of
      // the nearly resonant and of the soft mode, about delta P and omega P, some 3e-3.
      for (Eigen::Index i = 0; i < r.size(); ++i) {
        const double expected = i % block == 0 ? contact[i / block] / scale.length : 0.0;
        EXPECT_NEAR(r[i], expected, 1e-12) << "period " << period << ", entry " << i;
      }
    }
  }
}

TEST(PhaseProblem, TheMotionRepeatsWhateverThePhases) { expect_repetition(many_kinds()); }

// r(v) = .9 - .05 v - .01 v^2 at one of the stops.
System with_restitution_by_speed() {
  System system = many_kinds();
  system.stops[0].impact().restitution = Restitution(std::vector<double>{0.9, 0.05, 0.01});
  return system;
}

TEST(PhaseProblem, TheMotionRepeatsWithRestitutionBySpeed) {
  expect_repetition(with_restitution_by_speed());
}

// Without damping and with r = 1 on two stops.
System conservative() {
  System system = many_kinds();
  system.modal().delta.setZero();
  system.omega[3] = 2.1;
  for (Stop& stop : system.stops) stop.impact().restitution = Restitution(1.0);
  return system;
}

// Speeds cancel from their own equations there: contact holds whatever the phases, and the shooting
// equations, given the free impulses, miss by what remains of the laws of impact.
TEST(PhaseProblem, ConservativeMotionKeepsContactWhateverThePhases) {
  const System system = conservative();
  const PeriodicResponseAnswer answer = periodic_response(system, 2);
  ASSERT_TRUE(answer.response) << answer.why_not;
  for (const std::vector<int>& stops :
       {std::vector<int>{0}, {1}, {0, 0}, {0, 1}, {0, 1, 1}, {1, 0, 0, 1}}) {
    const PhaseProblem phases(*answer.response, stops, 1.0);
    EXPECT_FALSE(phases.remains_contact());
    Vector theta(static_cast<Eigen::Index>(stops.size()));
    for (Eigen::Index i = 0; i < theta.size(); ++i)
      theta[i] = 0.7 + 1.3 * static_cast<double>(i) + 0.1 * static_cast<double>(i * i);
    const std::vector<ImpactPoint> points = phases.points(theta);
    const Vector defect = phases.defect(theta);
    const std::size_t k = points.size();
    for (std::size_t i = 0; i < k; ++i) {
      const std::size_t next = (i + 1) % k;
      const Stop& stop = system.stops[static_cast<std::size_t>(stops[i])];
      EXPECT_NEAR(stop.row.dot(points[i].before.q), stop.gap, 1e-12);
      State after = after_impact(stop, points[i].before);
      after.qdot -= defect[static_cast<Eigen::Index>(i)] * 2.3 * stop.direction();
      const double turn = points[next].theta - theta[static_cast<Eigen::Index>(i)] +
                          (next == 0 ? 2.0 * kTurn : 0.0);
      const State end =
          transition(system, ExactFlow<double>(system), after, points[i].theta, turn / 2.3).end;
      EXPECT_LE((end.q - points[next].before.q).norm(), 1e-11);
      EXPECT_LE((end.qdot - points[next].before.qdot).norm(), 1e-11);
    }
  }
  EXPECT_TRUE(
      PhaseProblem(*periodic_response(many_kinds(), 2).response, {0}, 1.0).remains_contact());
}

void expect_phase_derivatives(const System& system) {
  const PeriodicResponseAnswer answer = periodic_response(system, 2);
  ASSERT_TRUE(answer.response);
  const std::vector<int> stops{0, 1, 0};
  const PhaseProblem problem(*answer.response, stops, 1.0);
  // The second and third are in another order than the impacts' numbers.
  for (const Vector& theta :
       {(Vector(3) << 0.4, 2.0, 7.0).finished(), (Vector(3) << 3.0, 2.0, 1.0).finished(),
        (Vector(3) << -5.0, 20.0, 0.3).finished()}) {
    Matrix jacobian;
    problem.defect(theta, &jacobian);
    for (Eigen::Index m = 0; m < 3; ++m) {
      // Central differences err by h^2 and eps/h: 1e-10 of the size at h = 1e-5.
      const double h = 1e-5;
      Vector up = theta, down = theta;
      up[m] += h;
      down[m] -= h;
      const Vector difference = (problem.defect(up) - problem.defect(down)) / (2.0 * h);
      EXPECT_LE((difference - jacobian.col(m)).norm(), 1e-7 * jacobian.norm());
    }
  }
}

TEST(PhaseProblem, DerivativesAgreeWithDifferences) {
  expect_phase_derivatives(many_kinds());
  expect_phase_derivatives(with_restitution_by_speed());
  expect_phase_derivatives(conservative());
}

TEST(PhaseProblem, ForOneImpactItIsTheClosedForm) {
  for (const char* name : {"sdof_2_8", "sdof_1_6", "three_modes_2_1", "beam_n2_40", "beam_n4_47"}) {
    SCOPED_TRACE(name);
    const System system = assemble(support::reference_scene(std::string("orbits/") + name));
    const MotionScale scale = motion_scale(system);
    const PeriodicResponseAnswer answer = periodic_response(system, 1);
    ASSERT_TRUE(answer.response);
    const PhaseProblem problem(*answer.response, {0}, 1.0);
    for (const ImpactPoint& exact :
         closed_form(system, 0, 1).form->solutions(system.stops[0].gap)) {
      const Vector theta = Vector::Constant(1, exact.theta);
      Vector speeds;
      EXPECT_NEAR(problem.defect(theta, nullptr, &speeds)[0] / scale.length, 0.0, 1e-12);
      EXPECT_NEAR(speeds[0], system.stops[0].row.dot(exact.before.qdot),
                  1e-11 * scale.length * system.forcing()->frequency);
    }
  }
}

// |kappa| of the closed form is the amplitude of contact over the phase; with a load, gap moved.
TEST(PhaseProblem, ContactOfOneImpactIsACosine) {
  const System system = many_kinds();
  const PeriodicResponseAnswer answer = periodic_response(system, 2);
  ASSERT_TRUE(answer.response);
  const PhaseProblem problem(*answer.response, {0}, 1.0);
  const ClosedFormAnswer exact = closed_form(system, 0, 2);
  ASSERT_TRUE(exact.form);
  for (int i = 0; i < 7; ++i) {
    const double theta = kTurn * i / 7.0;
    const double expected =
        std::abs(exact.form->kappa) * std::cos(theta + std::arg(exact.form->kappa)) +
        exact.form->moved - system.stops[0].gap;
    EXPECT_NEAR(problem.defect(Vector::Constant(1, theta))[0], expected, 1e-12);
  }
}

TEST(PhaseProblem, IsPeriodicOnTheTorus) {
  const System system = many_kinds();
  const PeriodicResponseAnswer answer = periodic_response(system, 3);
  ASSERT_TRUE(answer.response);
  const std::vector<int> stops{0, 1};
  const PhaseProblem problem(*answer.response, stops, 1.0);
  const Vector theta = (Vector(2) << 1.0, 4.0).finished();
  const Vector contact = problem.defect(theta);
  const double lap = 3.0 * kTurn;
  EXPECT_LE((problem.defect(theta + Vector::Unit(2, 0) * lap) - contact).norm(), 1e-12);
  EXPECT_LE((problem.defect(theta - Vector::Unit(2, 1) * lap) - contact).norm(), 1e-12);
  // A whole forcing period later everything is the same too.
  EXPECT_LE((problem.defect(theta.array() + kTurn) - contact).norm(), 1e-12);
}

// An undamped mode whose period divides p forcing periods, a free mass: E has the eigenvalue one.
TEST(PhaseProblem, SaysWhereAModeRepeatsByItself) {
  for (const double omega : {1.0, 2.0, 3.0, 0.0}) {
    const System system = support::forced_oscillator(omega, 0.0, 0.1, 0.8, 1.0, 1.0);
    const PeriodicResponseAnswer answer = periodic_response(system, 1);
    EXPECT_FALSE(answer.response) << omega;
    EXPECT_NE(answer.why_not.find("repeats by itself"), std::string::npos);
  }
  // Half a turn is not a whole one; two halves are.
  const System half = support::forced_oscillator(0.5, 0.0, 0.1, 0.8, 1.0, 1.0);
  EXPECT_TRUE(periodic_response(half, 1).response);
  EXPECT_FALSE(periodic_response(half, 2).response);
  // With damping it does not repeat, but a free mass keeps its place.
  EXPECT_TRUE(
      periodic_response(support::forced_oscillator(1.0, 0.01, 0.1, 0.8, 1.0, 1.0), 1).response);
  EXPECT_FALSE(
      periodic_response(support::forced_oscillator(0.0, 0.01, 0.1, 0.8, 1.0, 1.0), 1).response);
}

}  // namespace
}  // namespace graze
