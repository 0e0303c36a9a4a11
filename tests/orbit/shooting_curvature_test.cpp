// Second derivatives of the shooting equations against central differences of the first ones.
#include "graze/orbit/problem/detail/shooting_curvature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/system_family.hpp"
#include "graze/scene/parameter.hpp"
#include "support/differences.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// Unknowns at evenly spread phases from states of size 1, in no way a solution.
Vector arbitrary_unknowns(const System& system, const ImpactPattern& pattern, support::Dice& dice) {
  const int n = system.modes(), block = 2 * n + 1;
  Vector x = dice.vector(pattern.impacts() * block, -1.0, 1.0);
  for (int i = 0; i < pattern.impacts(); ++i)
    x[i * block] = 0.7 + 2.0 * std::numbers::pi * pattern.period * i / pattern.impacts();
  return x;
}

ComplexVector arbitrary_complex(Eigen::Index size, support::Dice& dice) {
  const int n = static_cast<int>(size);
  ComplexVector z = dice.vector(n, -1.0, 1.0).cast<Complex>();
  z += Complex(0.0, 1.0) * dice.vector(n, -1.0, 1.0);
  return z;
}

// w^T (jacobian + mu closing) v.
Complex paired(const ShootingLinearisation& at, const ComplexVector& w, const ComplexVector& v,
               Complex mu) {
  return w.transpose() *
         ((at.jacobian.cast<Complex>() + (mu - 1.0) * at.closing.cast<Complex>()) * v);
}

Vector parts(Complex z) { return Vector{{z.real(), z.imag()}}; }

void expect_curvature(const Scene& scene, const ImpactPattern& pattern) {
  const System system = assemble(scene);
  const ShootingProblem problem(pattern, motion_scale(system));
  support::Dice dice(11);
  const Vector x = arbitrary_unknowns(system, pattern, dice);
  const ComplexVector w = arbitrary_complex(x.size(), dice), v = arbitrary_complex(x.size(), dice);
  const Complex mu = std::polar(1.0, 0.8);
  const ComplexVector by_unknowns = shooting_curvature(problem, system, x, {}, w, v, mu);
  ASSERT_EQ(by_unknowns.size(), x.size());
  const auto paired_at = [&](const System& at, const Vector& y) {
    return parts(paired(problem.linearise(at, y, {}), w, v, mu));
  };
  const Matrix differences = support::central_jacobian(
      [&](const Vector& y) { return paired_at(system, y); }, x, Vector::Constant(x.size(), 1e-4));
  const double size = by_unknowns.cwiseAbs().maxCoeff();
  EXPECT_LE((by_unknowns.real() - differences.row(0).transpose()).cwiseAbs().maxCoeff(),
            1e-8 * size);
  EXPECT_LE((by_unknowns.imag() - differences.row(1).transpose()).cwiseAbs().maxCoeff(),
            1e-8 * size);

  int moved = 0;
  for (const std::string& name : parameter_names(scene)) {
    const SystemFamily family(scene, name);
    const double value = family.value();
    const double h = 2e-5 * (value == 0.0 ? 1e-2 : std::abs(value));
    if (!family.at(value - 2.0 * h) || !family.at(value + 2.0 * h)) continue;
    ++moved;
    const System tangent = *family.tangent_at(value);
    const System* tangents[] = {&tangent, &tangent};
    const ComplexVector gradient = shooting_curvature(problem, system, x, tangents, w, v, mu);
    const Vector difference = support::central_difference(
        [&](double p) { return paired_at(*family.at(p), x); }, value, h);
    const double scale = std::max(
        difference.norm(), 1e-3 * std::abs(paired(problem.linearise(system, x, {}), w, v, mu)) / h);
    EXPECT_LE((parts(gradient[x.size()]) - difference).norm(), 1e-7 * scale) << name;
    EXPECT_EQ(gradient[x.size()], gradient[x.size() + 1]);
    EXPECT_EQ(gradient.head(x.size()), by_unknowns);
  }
  EXPECT_GE(moved, 5);
}

void expect_curvatures(const Scene& scene) {
  expect_curvature(scene, {1, {0}});
  expect_curvature(scene, {1, {0, 0}});
  expect_curvature(scene, {2, {0, 0, 0}});
}

TEST(ShootingCurvature, OfOscillators) {
  for (const char* name : {"sdof_2_8", "sdof_1_6", "three_modes_2_1"}) {
    SCOPED_TRACE(name);
    expect_curvatures(support::reference_scene(std::string("orbits/") + name));
  }
}

TEST(ShootingCurvature, OfBeams) {
  for (const char* name : {"orbits/beam_n1_40", "orbits/beam_n4_40"}) {
    SCOPED_TRACE(name);
    expect_curvatures(support::reference_scene(name, {"stop.position=0.28"}));
  }
}

TEST(ShootingCurvature, WithOtherDampingForcingAndProjection) {
  expect_curvature(support::reference_scene("H", {"stop.position=0.25"}), {1, {0}});
  expect_curvature(support::reference_scene("D"), {1, {0, 0}});
  expect_curvature(support::reference_scene("F"), {1, {0}});
  expect_curvature(support::reference_scene("G"), {1, {0}});
  expect_curvature(support::reference_scene("C"), {2, {0, 0}});
  expect_curvature(support::reference_scene("paper_collocation"), {1, {0}});
}

TEST(ShootingCurvature, WithGravityAndRestitutionThatFallsWithTheSpeed) {
  expect_curvatures(support::reference_scene(
      "orbits/three_modes_2_1", {"modal.inertia=[0.7, -0.2, 0.4]", "gravity.acceleration=0.3",
                                 "stop.restitution=[0.9, 0.02, 0.001]"}));
  expect_curvatures(support::reference_scene(
      "orbits/beam_n2_40",
      {"stop.position=0.28", "gravity.acceleration=9.81", "stop.restitution=[0.85, 0.05, 0.004]"}));
}

TEST(ShootingCurvature, OfMassesAndSprings) {
  for (const char* arm : {"1.0", "0.8"})
    expect_curvatures(support::reference_scene(
        "lumped/hub", {"damping.ratio=0.05", std::string("lumped.masses.2=") + arm}));
  expect_curvature(support::reference_scene("lumped/apart"), {1, {0}});
}

TEST(ShootingCurvature, AtResonance) {
  expect_curvature(support::reference_scene("orbits/sdof_1_6", {"forcing.frequency=1.0",
                                                                "modal.damping_ratios=[0.0005]"}),
                   {1, {0, 0}});
}

}  // namespace
}  // namespace graze
