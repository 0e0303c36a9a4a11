// The closed form of (p, 1) orbits and what is made of it, against tests/reference (50 digits).
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/base/angle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graze/flow/exact/extended.hpp"
#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/orbit/problem/orbit.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

struct Case {
  System system;
  int period;
  double phase;
  std::string name;
};

Case case_of(const support::TableRow& row) {
  return {assemble(support::reference_scene("orbits/" + row.at("case"))),
          std::stoi(row.at("period")), support::number(row, "phase"),
          row.at("case") + " at " + row.at("phase")};
}

ImpactPoint solution_of(const Case& c) {
  const ClosedFormAnswer answer = closed_form(c.system, 0, c.period);
  EXPECT_TRUE(answer.form) << answer.why_not;
  const std::vector<ImpactPoint> points = answer.form->solutions(c.system.stops[0].gap);
  EXPECT_EQ(points.size(), 2u);
  const double first = std::abs(std::remainder(points[0].theta - c.phase, kTurn));
  const double second = std::abs(std::remainder(points[1].theta - c.phase, kTurn));
  return first < second ? points[0] : points[1];
}

Orbit orbit_of(const Case& c, const ImpactPoint& point) {
  const ShootingProblem problem({c.period, {0}}, motion_scale(c.system));
  return make_orbit(c.system, problem, problem.pack(c.system, {point}));
}

std::vector<Complex> reference_multipliers(const support::TableRow& row) {
  std::vector<Complex> list;
  for (int j = 1; j <= 8 && !row.at("mult_re" + std::to_string(j)).empty(); ++j)
    list.emplace_back(support::number(row, "mult_re" + std::to_string(j)),
                      support::number(row, "mult_im" + std::to_string(j)));
  return list;
}

TEST(ClosedForm, AgreesWithTheReference) {
  for (const support::TableRow& row : support::read_table("closed_form_orbits.csv")) {
    const Case c = case_of(row);
    SCOPED_TRACE(c.name);
    const ImpactPoint point = solution_of(c);
    EXPECT_NEAR(std::remainder(point.theta - c.phase, kTurn), 0.0, 1e-12);
    EXPECT_NEAR(c.system.stops[0].row.dot(point.before.qdot), support::number(row, "speed"), 1e-12);
    EXPECT_NEAR(c.system.stops[0].row.dot(point.before.q), c.system.stops[0].gap, 1e-14);
  }
}

TEST(ClosedForm, MultipliersAgreeWithTheReference) {
  for (const support::TableRow& row : support::read_table("closed_form_orbits.csv")) {
    const Case c = case_of(row);
    SCOPED_TRACE(c.name);
    const Orbit orbit = orbit_of(c, solution_of(c));
    const std::vector<Complex> expected = reference_multipliers(row);
    ASSERT_EQ(orbit.multipliers.size(), expected.size());
    bool unstable = false;
    for (const Complex& value : expected) {
      double smallest = 1e300;
      for (const Eigenvalue& m : orbit.multipliers)
        smallest = std::min(smallest, std::abs(m.value - value));
      EXPECT_LE(smallest, 1e-10 * std::max(1.0, std::abs(value))) << value;
      unstable = unstable || std::abs(value) > 1.0;
    }
    ASSERT_TRUE(orbit.stable);
    EXPECT_EQ(*orbit.stable, !unstable);
    for (std::size_t i = 1; i < orbit.multipliers.size(); ++i)
      EXPECT_LE(std::abs(orbit.multipliers[i].value), std::abs(orbit.multipliers[i - 1].value));
  }
}

TEST(ClosedForm, NewtonKeepsIt) {
  for (const support::TableRow& row : support::read_table("closed_form_orbits.csv")) {
    const Case c = case_of(row);
    SCOPED_TRACE(c.name);
    const ShootingProblem problem({c.period, {0}}, motion_scale(c.system));
    const auto solution = newton(problem, c.system, problem.pack(c.system, {solution_of(c)}));
    ASSERT_TRUE(solution);
    EXPECT_LE(solution->residual, 1e-13);
    const ImpactPoint point = problem.unpack(c.system, solution->x).front();
    EXPECT_NEAR(std::remainder(point.theta - c.phase, kTurn), 0.0, 1e-12);
    EXPECT_NEAR(c.system.stops[0].row.dot(point.before.qdot), support::number(row, "speed"), 1e-12);
  }
}

TEST(ClosedForm, ClearanceAndAdmissibilityAgreeWithTheReference) {
  const auto orbits = support::read_table("closed_form_orbits.csv");
  const auto clearances = support::read_table("closed_form_clearances.csv");
  ASSERT_EQ(orbits.size(), clearances.size());
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    ASSERT_EQ(orbits[i].at("case"), clearances[i].at("case"));
    ASSERT_EQ(orbits[i].at("phase"), clearances[i].at("phase"));
    const Case c = case_of(orbits[i]);
    SCOPED_TRACE(c.name);
    const Orbit orbit = orbit_of(c, solution_of(c));
    const std::string& expected = clearances[i].at("clearance");
    ASSERT_EQ(orbit.clearance.has_value(), !expected.empty());
    if (orbit.clearance) {
      EXPECT_NEAR(*orbit.clearance, std::stod(expected), 1e-12);
    }
    const bool clear = expected.empty() || std::stod(expected) > 0.0;
    EXPECT_EQ(orbit.admissible, clear && support::number(orbits[i], "speed") > 0.0);
  }
}

TEST(ClosedForm, FoldsAgreeWithTheReference) {
  for (const support::TableRow& row : support::read_table("closed_form_folds.csv")) {
    if (row.at("parameter") != "stop.gap") continue;
    SCOPED_TRACE(row.at("case"));
    const System system = assemble(support::reference_scene("orbits/" + row.at("case")));
    const ClosedFormAnswer answer = closed_form(system, 0, 1);
    ASSERT_TRUE(answer.form);
    // |kappa| does not depend on the gap: the fold stands at gap = |kappa|.
    EXPECT_NEAR(std::abs(answer.form->kappa) / support::number(row, "value"), 1.0, 1e-12);
    EXPECT_NEAR(
        std::remainder(-std::arg(answer.form->kappa) - support::number(row, "phase"), kTurn), 0.0,
        1e-12);
  }
}

// A constant load moves the gap; the shooting equations, which know nothing of the closed form,
// agree.
TEST(ClosedForm, HoldsUnderAConstantLoad) {
  int found = 0;
  for (const char* name : {"sdof_1_6", "three_modes_2_1", "beam_n2_40", "beam_n4_40"}) {
    System system = assemble(support::reference_scene(std::string("orbits/") + name));
    for (const double part : {-0.4, 0.1, 0.5}) {
      SCOPED_TRACE(name);
      system.modal().load = part * system.forcing()->amplitude;
      const ClosedFormAnswer answer = closed_form(system, 0, 1);
      ASSERT_TRUE(answer.form);
      const ShootingProblem problem({1, {0}}, motion_scale(system));
      for (const ImpactPoint& point : answer.form->solutions(system.stops[0].gap)) {
        ++found;
        EXPECT_LE(problem.residual(system, problem.pack(system, {point})).cwiseAbs().maxCoeff(), 1e-11);
      }
    }
  }
  EXPECT_GE(found, 12);
}

TEST(ClosedForm, HasNoSolutionBeyondTheFold) {
  const System system = assemble(support::reference_scene("orbits/beam_n2_40"));
  const ClosedFormAnswer answer = closed_form(system, 0, 1);
  ASSERT_TRUE(answer.form);
  const double fold = std::abs(answer.form->kappa);
  EXPECT_TRUE(answer.form->solutions(fold * (1.0 + 1e-14)).empty());
  EXPECT_EQ(answer.form->solutions(fold * (1.0 - 1e-14)).size(), 2u);
  EXPECT_EQ(answer.form->solutions(-fold * (1.0 - 1e-14)).size(), 2u);
  EXPECT_TRUE(answer.form->solutions(-fold * (1.0 + 1e-14)).empty());
}

TEST(ClosedForm, NeedsForcing) {
  const ClosedFormAnswer answer = closed_form(support::oscillator(1.0, 0.1, 0.1, 0.8), 0, 1);
  EXPECT_FALSE(answer.form);
  EXPECT_FALSE(answer.why_not.empty());
}

// x'' + 2 delta x' + x = cos(W t), one impact per period, in 50 digits: complex numbers by hand.
struct PreciseOrbit {
  double phases[2], speeds[2];
};

PreciseOrbit precise_orbit(double delta_, double frequency, double gap, double restitution) {
  using Real = Extended;
  const Real delta = delta_, w = frequency, r = restitution;
  const Real pi = acos(Real(-1)), time = 2 * pi / w, wd = sqrt(1 - delta * delta);
  const Real decay = exp(-delta * time), sine = decay * sin(wd * time) / wd;
  const Real cosine = decay * cos(wd * time);
  const Real e[4] = {cosine + delta * sine, sine, -sine, cosine - delta * sine};
  // Steady response Re(Y e^{i phi}), Y = 1/(1 - W^2 + 2 i delta W); rows q and q' of (I - E) Y.
  const Real re = 1 - w * w, im = 2 * delta * w, norm = re * re + im * im;
  const Real y[4] = {re / norm, -im / norm, w * im / norm, w * re / norm};  // Y, i W Y
  const Real b[4] = {y[0] - e[0] * y[0] - e[1] * y[2], y[1] - e[0] * y[1] - e[1] * y[3],
                     y[2] - e[2] * y[0] - e[3] * y[2], y[3] - e[2] * y[1] - e[3] * y[3]};
  // I - E J with J = diag(1, -r)
  const Real a[4] = {1 - e[0], r * e[1], -e[2], 1 + r * e[3]}, det = a[0] * a[3] - a[1] * a[2];
  const Real k_re = (a[3] * b[0] - a[1] * b[2]) / det, k_im = (a[3] * b[1] - a[1] * b[3]) / det;
  const Real v_re = (a[0] * b[2] - a[2] * b[0]) / det, v_im = (a[0] * b[3] - a[2] * b[1]) / det;
  const Real size = sqrt(k_re * k_re + k_im * k_im), half = acos(gap / size);
  PreciseOrbit orbit{};
  for (int i = 0; i < 2; ++i) {
    const Real phase = (i == 0 ? Real(-half) : half) - atan2(k_im, k_re);
    orbit.phases[i] = static_cast<double>(phase);
    orbit.speeds[i] = static_cast<double>(v_re * cos(phase) - v_im * sin(phase));
  }
  return orbit;
}

TEST(ClosedForm, HoldsThroughResonance) {
  for (const double delta : {5e-2, 5e-4, 5e-6}) {
    for (const double detuning : {0.0, 1e-12, 1e-8, 1e-5, 1e-3, 2e-3, 1e-2, 0.1}) {
      SCOPED_TRACE(testing::Message() << "delta " << delta << ", detuning " << detuning);
      const System system = support::forced_oscillator(1.0, delta, 0.3, 0.5, 1.0 + detuning, 1.0);
      const PreciseOrbit exact = precise_orbit(delta, 1.0 + detuning, 0.3, 0.5);
      const ClosedFormAnswer answer = closed_form(system, 0, 1);
      ASSERT_TRUE(answer.form) << answer.why_not;
      const std::vector<ImpactPoint> points = answer.form->solutions(0.3);
      ASSERT_EQ(points.size(), 2u);
      // I - E is delta T or the detuning, and eps is divided by it.
      const double tolerance = 1e-14 + 1e-15 / std::max(delta, detuning);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(std::remainder(points[i].theta - exact.phases[i], kTurn), 0.0, tolerance);
        EXPECT_NEAR(points[i].before.qdot[0], exact.speeds[i], tolerance);
      }
    }
  }
}

// Undamped and with r = 1 the free motion fits whatever the speed: I - E J is singular. What
// repeats is even about the impact and the middle of the flight,
//
//   x = X cos(W t) + A cos(w (t - P/2)),     X = F/(w^2 - W^2),
//
// with the impact at a crest of the forcing, phase 0 or pi, where X cos + A cos(w P/2) = gap.
TEST(ClosedForm, HoldsWithoutDampingAndLossAtImpacts) {
  for (const double frequency : {0.7, 1.8, 2.6, 3.2, 5.0})
    for (const int period : {1, 2, 3})
      for (const double gap : {-0.3, 0.0, 0.2}) {
        SCOPED_TRACE(testing::Message()
                     << "W " << frequency << ", p " << period << ", gap " << gap);
        const System system = support::forced_oscillator(1.0, 0.0, gap, 1.0, frequency, 1.0);
        const ClosedFormAnswer answer = closed_form(system, 0, period);
        ASSERT_TRUE(answer.form) << answer.why_not;
        std::vector<ImpactPoint> points = answer.form->solutions(gap);
        ASSERT_EQ(points.size(), 2u);
        if (std::cos(points[0].theta) < 0.0) std::swap(points[0], points[1]);
        const double size = 1.0 / (1.0 - frequency * frequency);
        const double tangent = std::tan(0.5 * kTurn * period / frequency);
        for (std::size_t i = 0; i < 2; ++i) {
          const double crest = i == 0 ? size : -size;
          EXPECT_NEAR(std::remainder(points[i].theta - (i == 0 ? 0.0 : 0.5 * kTurn), kTurn), 0.0,
                      1e-13);
          EXPECT_NEAR(points[i].before.q[0], gap, 1e-13);
          const double speed = -(gap - crest) * tangent;
          EXPECT_NEAR(points[i].before.qdot[0], speed, 1e-12 * (1.0 + std::abs(speed)));
        }
      }
}

// Several modes and a load: the shooting equations agree. Nearly no damping and loss as well, where
// the way by the motion keeps few digits.
TEST(ClosedForm, HoldsAtAndBesideConservativeMotion) {
  for (const double lost : {0.0, 1e-15, 1e-12, 1e-9, 1e-7, 1e-5}) {
    SCOPED_TRACE(lost);
    System system;
    system.omega = (Vector(3) << 1.0, 6.3, 17.5).finished();
    system.modal().delta = Vector::Constant(3, lost);
    system.modal().forcing = HarmonicForcing{1.8, 0.4, (Vector(3) << 1.0, 0.4, -0.2).finished()};
    system.modal().load = (Vector(3) << 0.03, -0.02, 0.01).finished();
    const Vector row = (Vector(3) << 1.0, -0.8, 0.6).finished();
    system.stops.push_back({row, 0.2, ImpactLaw{row / row.squaredNorm(), 1.0 - lost}});
    const ClosedFormAnswer answer = closed_form(system, 0, 1);
    ASSERT_TRUE(answer.form) << answer.why_not;
    const std::vector<ImpactPoint> points = answer.form->solutions(0.2);
    ASSERT_EQ(points.size(), 2u);
    const ShootingProblem problem({1, {0}}, motion_scale(system));
    // I - E J is about `lost`: far enough from zero it is solved with, and eps is divided by it.
    const double tolerance = lost > 1e-6 ? 1e-15 / lost : 1e-12;
    for (const ImpactPoint& point : points)
      EXPECT_LE(problem.residual(system, problem.pack(system, {point})).cwiseAbs().maxCoeff(), tolerance);
  }
}

TEST(ClosedForm, SaysWhereTheMotionRepeatsByItself) {
  // Undamped and forced at its own frequency, any displacement comes back after a period.
  const ClosedFormAnswer answer =
      closed_form(support::forced_oscillator(1.0, 0.0, 0.3, 0.5, 1.0, 1.0), 0, 1);
  EXPECT_FALSE(answer.form);
  EXPECT_NE(answer.why_not.find("singular"), std::string::npos) << answer.why_not;
}

TEST(ClosedForm, HoldsForFourHundredModes) {
  for (const int modes : {16, 64, 200, 400}) {
    const System system = assemble(
        support::reference_scene("orbits/beam_n4_33", {"beam.modes=" + std::to_string(modes)}));
    const ClosedFormAnswer answer = closed_form(system, 0, 1);
    ASSERT_TRUE(answer.form) << modes << ": " << answer.why_not;
    const ShootingProblem problem({1, {0}}, motion_scale(system));
    for (const ImpactPoint& point : answer.form->solutions(system.stops[0].gap))
      EXPECT_LE(problem.residual(system, problem.pack(system, {point})).cwiseAbs().maxCoeff(), 1e-12)
          << modes;
  }
}

}  // namespace
}  // namespace graze
