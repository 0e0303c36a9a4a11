// Systems over a parameter: tangents against differences, nothing outside the parameter's range.
#include "graze/assembly/system_family.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"
#include "support/differences.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

// Every number of a system, one after the other.
Vector numbers(const System& system) {
  std::vector<double> list;
  const auto add = [&](const Vector& v) { list.insert(list.end(), v.begin(), v.end()); };
  add(system.omega);
  add(system.delta());
  if (system.forcing()) {
    list.push_back(system.forcing()->frequency);
    list.push_back(system.forcing()->phase);
    add(system.forcing()->amplitude);
  }
  if (system.load()) add(*system.load());
  for (const Stop& stop : system.stops) {
    add(stop.row);
    list.push_back(stop.gap);
    add(stop.direction());
    for (const double a : stop.restitution().coefficients()) list.push_back(a);
  }
  return Eigen::Map<const Vector>(list.data(), static_cast<Eigen::Index>(list.size()));
}

// Returns the names that could be moved both ways.
std::vector<std::string> expect_tangents(const Scene& scene) {
  std::vector<std::string> moved;
  for (const std::string& name : parameter_names(scene)) {
    const SystemFamily family(scene, name);
    const double value = family.value(), h = 1e-4 * (value == 0.0 ? 1.0 : std::abs(value));
    if (!family.at(value - 2.0 * h) || !family.at(value + 2.0 * h)) continue;
    moved.push_back(name);
    const Vector tangent = numbers(*family.tangent_at(value));
    const Vector difference =
        support::central_difference([&](double p) { return numbers(*family.at(p)); }, value, h);
    const Vector here = numbers(*family.at(value));
    // What is assembled once for a whole branch does not depend on the parameter.
    SystemCursor cursor(family);
    EXPECT_TRUE(cursor.at(value)) << name;
    EXPECT_EQ(numbers(*cursor.at(value + h)), numbers(*family.at(value + h))) << name;
    for (Eigen::Index i = 0; i < tangent.size(); ++i) {
      // Rounding of the differences: eps of the number over the step.
      const double rounding = 1e-14 * std::abs(here[i]) / h;
      EXPECT_NEAR(tangent[i], difference[i], 1e-9 * std::abs(difference[i]) + rounding + 1e-12)
          << name << ", number " << i;
    }
  }
  return moved;
}

TEST(SystemFamily, TangentsOfBeams) {
  const auto moved =
      expect_tangents(support::reference_scene("orbits/beam_n4_40", {"stop.position=0.27"}));
  EXPECT_EQ(moved, (std::vector<std::string>{
                       "beam.length", "beam.youngs_modulus", "beam.second_moment", "beam.density",
                       "beam.area", "damping.viscous", "forcing.amplitude", "forcing.frequency",
                       "forcing.phase", "stop.position", "stop.gap", "stop.restitution"}));
  EXPECT_GE(expect_tangents(support::reference_scene("B", {"stop.position=0.27"})).size(), 11u);
  EXPECT_GE(expect_tangents(support::reference_scene("D")).size(), 11u);
}

TEST(SystemFamily, TangentsOfBeamsWithOtherDampingAndForcing) {
  EXPECT_GE(expect_tangents(support::reference_scene("H", {"stop.position=0.27"})).size(), 12u);
  EXPECT_GE(expect_tangents(
                support::reference_scene("orbits/beam_n2_40",
                                         {"damping={ ratios = [0.01, 0.03] }", "stop.position=0.27",
                                          "forcing.kind=\"distributed\""}))
                .size(),
            12u);
}

TEST(SystemFamily, TangentsOfCollocationPoints) {
  const auto moved = expect_tangents(
      support::reference_scene("B", {"beam.points=[0.11, 0.26]", "stop.position=0.2"}));
  EXPECT_NE(std::find(moved.begin(), moved.end(), "beam.points.1"), moved.end());
  EXPECT_NE(std::find(moved.begin(), moved.end(), "beam.points.2"), moved.end());
  EXPECT_GE(expect_tangents(support::reference_scene("paper_collocation")).size(), 8u);
  EXPECT_GE(expect_tangents(support::reference_scene("C")).size(), 8u);
}

TEST(SystemFamily, TangentsOfGivenModes) {
  EXPECT_GE(expect_tangents(support::reference_scene("orbits/three_modes_2_1")).size(), 14u);
  EXPECT_GE(expect_tangents(support::reference_scene("F")).size(), 10u);
  EXPECT_GE(expect_tangents(support::reference_scene("G")).size(), 10u);
}

TEST(SystemFamily, TangentsOfForcesAtPoints) {
  EXPECT_GE(expect_tangents(
                parse_scene("[modal]\nfrequencies = [10.0, 25.0]\ndamping_ratios = [0.05, 0.02]\n"
                            "[forcing]\nshape = [1.0, 0.4]\namplitude = 20.0\nfrequency = 14.0\n"
                            "[[load]]\nshape = [0.3, 0.2]\nforce = 2.0\n"
                            "[[stop]]\nshape = [1.0, -0.5]\ngap = 0.02\nrestitution = 0.8\n",
                            "modes"))
                .size(),
            15u);
  EXPECT_GE(expect_tangents(
                parse_scene("[bar]\nlength = 2.0\nyoungs_modulus = 2e11\ndensity = 7800.0\n"
                            "area = 1e-4\nmodes = 3\n[damping]\nratio = 0.01\n"
                            "[forcing]\nposition = 1.1\namplitude = 20.0\nfrequency = 1400.0\n"
                            "[[load]]\nposition = 1.7\nforce = 2.0\n"
                            "[[stop]]\nposition = 1.9\ngap = 0.02\nrestitution = 0.8\n",
                            "bar"))
                .size(),
            12u);
}

TEST(SystemFamily, HasNothingOutsideTheParametersRange) {
  const Scene scene = support::shipped_scene("02_wagg_momentum");
  EXPECT_FALSE(SystemFamily(scene, "beam.length").at(-0.3));
  EXPECT_FALSE(SystemFamily(scene, "stop.position").at(0.31));
  EXPECT_FALSE(SystemFamily(scene, "stop.restitution").at(1.01));
  EXPECT_FALSE(SystemFamily(scene, "stop.restitution").tangent_at(-0.01));
  EXPECT_FALSE(SystemFamily(scene, "forcing.frequency").at(0.0));
  EXPECT_FALSE(SystemFamily(scene, "forcing.frequency").at(std::nan("")));
  EXPECT_TRUE(SystemFamily(scene, "stop.restitution").at(1.0));
  EXPECT_TRUE(SystemFamily(scene, "stop.gap").at(-1e-3));
}

TEST(SystemFamily, KnowsItsParameter) {
  const Scene scene = support::shipped_scene("02_wagg_momentum");
  const SystemFamily family(scene, "forcing.frequency");
  EXPECT_EQ(family.parameter(), "forcing.frequency");
  EXPECT_EQ(family.value(), 28.3);
  EXPECT_EQ(family.at(30.0)->forcing()->frequency, 30.0);
  EXPECT_THROW(SystemFamily(scene, "forcing.frequenzy"), InputError);
  EXPECT_THROW(SystemFamily(scene, "beam.modes"), InputError);
}

}  // namespace
}  // namespace graze
