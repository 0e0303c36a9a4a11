// The shooting equations: analytic derivatives against central differences.
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/assembly/assembly.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "graze/assembly/system_family.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/scene/parameter.hpp"
#include "support/differences.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// Impacts at evenly spread phases from states of the system's own size, in no way a solution.
std::vector<ImpactPoint> arbitrary_points(const System& system, const ImpactPattern& pattern,
                                          support::Dice& dice) {
  const MotionScale scale = motion_scale(system);
  const int n = system.modes();
  std::vector<ImpactPoint> points;
  for (int i = 0; i < pattern.impacts(); ++i)
    points.push_back({0.7 + 2.0 * std::numbers::pi * pattern.period * i / pattern.impacts(),
                      {scale.displacement * dice.vector(n, -1.0, 1.0),
                       scale.velocity.cwiseProduct(dice.vector(n, -1.0, 1.0))}});
  return points;
}

void expect_derivatives(const Scene& scene, const ImpactPattern& pattern) {
  const System system = assemble(scene);
  const ShootingProblem problem(pattern, motion_scale(system));
  support::Dice dice(7);
  const Vector x = problem.pack(system, arbitrary_points(system, pattern, dice));
  Matrix jacobian;
  const Vector r = problem.residual(system, x, &jacobian);
  ASSERT_EQ(r.size(), problem.size(system));
  // The equations are linear in the states; only the phases bend them.
  const Matrix differences =
      support::central_jacobian([&](const Vector& y) { return problem.residual(system, y); }, x,
                                Vector::Constant(x.size(), 1e-4));
  const double size = jacobian.cwiseAbs().maxCoeff();
  EXPECT_LE((jacobian - differences).cwiseAbs().maxCoeff() / size, 1e-8);

  int moved = 0;
  for (const std::string& name : parameter_names(scene)) {
    const SystemFamily family(scene, name);
    const double value = family.value();
    // The highest mode turns by some 300 rad: steps that leave h^4 300^5/30 below the tolerance.
    const double h = 2e-5 * (value == 0.0 ? 1e-2 : std::abs(value));
    if (!family.at(value - 2.0 * h) || !family.at(value + 2.0 * h)) continue;
    ++moved;
    const System tangent = *family.tangent_at(value);
    const System* tangents[] = {&tangent};
    const Vector derivative = problem.linearise(system, x, tangents).by_parameters;
    const Vector difference = support::central_difference(
        [&](double p) { return problem.residual(*family.at(p), x); }, value, h);
    const double scale = std::max(difference.cwiseAbs().maxCoeff(), 1e-3 * r.norm() / h);
    EXPECT_LE((derivative - difference).cwiseAbs().maxCoeff(), 1e-7 * scale) << name;
  }
  EXPECT_GE(moved, 5);
}

// The tip stop of a scene, moved off the end so that it can be varied both ways.
Scene inner_stop(const std::string& name, std::vector<std::string> settings) {
  settings.push_back("stop.position=0.28");
  return support::reference_scene(name, settings);
}

TEST(Shooting, DerivativesOfOscillators) {
  for (const char* name : {"sdof_2_8", "sdof_1_6", "three_modes_2_1"}) {
    SCOPED_TRACE(name);
    const Scene scene = support::reference_scene(std::string("orbits/") + name);
    expect_derivatives(scene, {1, {0}});
    expect_derivatives(scene, {1, {0, 0}});
    expect_derivatives(scene, {2, {0, 0}});
  }
}

TEST(Shooting, DerivativesOfBeams) {
  for (const char* name : {"orbits/beam_n1_40", "orbits/beam_n2_40", "orbits/beam_n4_40"}) {
    SCOPED_TRACE(name);
    expect_derivatives(inner_stop(name, {}), {1, {0}});
    expect_derivatives(inner_stop(name, {}), {2, {0, 0}});
  }
}

TEST(Shooting, DerivativesWithOtherDampingAndForcing) {
  expect_derivatives(support::reference_scene("H", {"stop.position=0.25"}), {1, {0}});
  expect_derivatives(support::reference_scene("D"), {1, {0, 0}});
  expect_derivatives(support::reference_scene("F"), {1, {0}});
  expect_derivatives(support::reference_scene("G"), {1, {0}});
}

TEST(Shooting, DerivativesWithTheCollocationProjectionAndLaw) {
  expect_derivatives(inner_stop("B", {"beam.points=[0.12, 0.27]"}), {1, {0}});
  expect_derivatives(support::reference_scene("paper_collocation"), {1, {0}});
  expect_derivatives(support::reference_scene("C"), {2, {0, 0}});
}

TEST(Shooting, DerivativesWithGravityAndRestitutionThatFallsWithTheSpeed) {
  for (const char* name : {"orbits/sdof_1_6", "orbits/three_modes_2_1"}) {
    const int modes = support::reference_scene(name).modes();
    const std::string inertia =
        modes == 1 ? "modal.inertia=[0.7]" : "modal.inertia=[0.7, -0.2, 0.4]";
    expect_derivatives(support::reference_scene(name, {inertia, "gravity.acceleration=0.3",
                                                       "stop.restitution=[0.9, 0.02, 0.001]"}),
                       {1, {0, 0}});
  }
  expect_derivatives(inner_stop("orbits/beam_n2_40",
                                {"gravity.acceleration=9.81", "stop.restitution=[0.85, 0.05]"}),
                     {1, {0}});
}

// At equal arms a mode changes its sign: the differences reach over that.
TEST(Shooting, DerivativesOfMassesAndSprings) {
  for (const char* arm : {"1.0", "0.8"}) {
    const Scene hub = support::reference_scene(
        "lumped/hub", {"damping.ratio=0.05", std::string("lumped.masses.2=") + arm});
    expect_derivatives(hub, {1, {0}});
    expect_derivatives(hub, {2, {0, 0}});
  }
  expect_derivatives(support::reference_scene("lumped/apart"), {2, {0, 0}});
}

TEST(Shooting, DerivativesAtResonance) {
  // The forcing at the natural frequency: the third mode kind of the flow's tangent.
  expect_derivatives(support::reference_scene("orbits/sdof_1_6", {"forcing.frequency=1.0",
                                                                  "modal.damping_ratios=[0.0005]"}),
                     {1, {0}});
}

TEST(Shooting, PackedPointsComeBack) {
  const System system = assemble(support::reference_scene("orbits/beam_n4_40"));
  const ShootingProblem problem({2, {0, 0}}, motion_scale(system));
  support::Dice dice(3);
  const auto points = arbitrary_points(system, problem.pattern(), dice);
  const auto back = problem.unpack(system, problem.pack(system, points));
  ASSERT_EQ(back.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back[i].theta, points[i].theta);
    EXPECT_LE((back[i].before.q - points[i].before.q).norm(), 1e-15 * points[i].before.q.norm());
    EXPECT_LE((back[i].before.qdot - points[i].before.qdot).norm(),
              1e-15 * points[i].before.qdot.norm());
  }
}

TEST(Shooting, ResidualVanishesOnTheClosedForm) {
  for (const support::TableRow& row : support::read_table("closed_form_orbits.csv")) {
    const System system = assemble(support::reference_scene("orbits/" + row.at("case")));
    const int period = std::stoi(row.at("period"));
    const ShootingProblem problem({period, {0}}, motion_scale(system));
    const ClosedFormAnswer answer = closed_form(system, 0, period);
    ASSERT_TRUE(answer.form);
    for (const ImpactPoint& point : answer.form->solutions(system.stops[0].gap))
      EXPECT_LE(problem.residual(system, problem.pack(system, {point})).cwiseAbs().maxCoeff(), 1e-12)
          << row.at("case");
  }
}

TEST(Shooting, ImpactTurnsTheApproachSpeedRound) {
  support::Dice dice(5);
  const Vector row = dice.vector(4, -2.0, 2.0);
  const Stop stop{row, 1.0, ImpactLaw{momentum_direction(row), 0.7}};
  const State before{dice.vector(4, -1.0, 1.0), dice.vector(4, -1.0, 1.0)};
  const State after = after_impact(stop, before);
  EXPECT_EQ(after.q, before.q);
  EXPECT_NEAR(row.dot(after.qdot), -0.7 * row.dot(before.qdot), 1e-15);
}

}  // namespace
}  // namespace graze
