#include "graze/assembly/detail/spring_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "graze/assembly/assembly.hpp"
#include "graze/contact/detail/restitution_damping.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

Scene scene_with(const std::string& spring) {
  return parse_scene(
      "[modal]\nfrequencies = [10.0]\n[[stop]]\nshape = [1.0]\ngap = 0.0\n[stop.spring]\n" + spring,
      "scene.toml");
}

ContactForce law_of(const std::string& spring) {
  return assemble(scene_with(spring)).stops.front().force();
}

// Yigit, Ulsoy & Scott (1990): C1 = 1.92e8 kg/(m s) from alpha_1 = 0.08 s/m and k = 3.2e9.
TEST(SpringLaw, OfThePaper) {
  const ContactForce first = law_of(
      "stiffness = 3.2e9\nexponent = 1.5\ndamping = { model = \"lee-wang-1\", alpha = 0.08 }\n");
  EXPECT_EQ(first.damping, ContactDamping::kDepth);
  EXPECT_NEAR(first.coefficient, 1.92e8, 1.0);
  const ContactForce second = law_of(
      "stiffness = 3.2e9\nexponent = 1.5\ndamping = { model = \"lee-wang-2\", coefficient = 800, "
      "onset = 0.5e-5 }\n");
  EXPECT_EQ(second.damping, ContactDamping::kOnset);
  EXPECT_EQ(second.coefficient, 800.0);
  EXPECT_EQ(second.onset_depth, 0.5e-5);
  EXPECT_EQ(second.onset_sharpness, 3.0);
  EXPECT_NEAR(second.resistance(1e-12), 800.0 * std::exp(-6.0), 1e-5);
}

TEST(SpringLaw, FromGeometry) {
  const ContactForce law =
      law_of("radii = [6.3e-3, 12.6e-3]\nmoduli = [68.95e9, 68.95e9]\npoisson = [0.3, 0.3]\n");
  EXPECT_EQ(law.exponent, 1.5);
  EXPECT_NEAR(law.stiffness, 3.27e9, 0.005e9);
}

// Asked for a restitution, each model gives what its closed form says, and "exact" what was asked.
TEST(SpringLaw, RestitutionInPrintAndExactly) {
  const double e = 0.5, v = 0.2, k = 1e8;
  const auto given = [&](const std::string& model, const std::string& inversion) {
    const ContactForce law =
        law_of("stiffness = 1e8\nexponent = 1.5\ndamping = { model = \"" + model +
               "\", restitution = 0.5, speed = 0.2" + inversion + " }\n");
    return restitution_of_power_damping(law.coefficient / k * v);
  };
  EXPECT_NEAR(given("hunt-crossley", ""), 0.6629622, 5e-8);
  EXPECT_NEAR(given("lankarani-nikravesh", ""), 0.72524111, 5e-9);
  EXPECT_NEAR(given("flores", ""), 0.47044478, 5e-9);
  for (const char* model : {"hunt-crossley", "lankarani-nikravesh", "flores"})
    EXPECT_NEAR(given(model, ", inversion = \"exact\""), e, 1e-15) << model;

  const auto ratio = [&](const std::string& rest) {
    const ContactForce law = law_of(
        "stiffness = 1e4\nexponent = 1\ndamping = { model = \"kelvin-voigt\", restitution = 0.5, "
        "mass = 0.3" +
        rest);
    return law.coefficient / (2.0 * std::sqrt(1e4 * 0.3));
  };
  EXPECT_NEAR(restitution_at_zero_depth(ratio(" }\nrelease = \"position\"\n")), e, 1e-15);
  EXPECT_NEAR(restitution_at_zero_force(ratio(", inversion = \"exact\" }\n")), e, 1e-15);
}

// The rates of the assembled law against differences of assembled laws.
TEST(SpringLaw, MovesWithTheNumbersOfTheScene) {
  const std::vector<std::string> springs = {
      "stiffness = 3e4\nexponent = 1.5\n",
      "stiffness = 3e4\nexponent = 1\ndamping = { model = \"kelvin-voigt\", ratio = 0.2, mass = "
      "0.3 "
      "}\n",
      "stiffness = 3e4\nexponent = 1\ndamping = { model = \"kelvin-voigt\", restitution = 0.7, "
      "mass "
      "= 0.3 }\n",
      "stiffness = 3e4\nexponent = 1\ndamping = { model = \"kelvin-voigt\", restitution = 0.7, "
      "mass "
      "= 0.3, inversion = \"exact\" }\n",
      "stiffness = 3e4\nexponent = 1.5\ndamping = { model = \"lee-wang-1\", alpha = 0.3 }\n",
      "stiffness = 3e4\nexponent = 1\ndamping = { model = \"lee-wang-2\", restitution = 0.6, mass "
      "= "
      "0.3, onset = 1e-2, sharpness = 2 }\n",
      "stiffness = 3e4\nexponent = 1.5\ndamping = { model = \"hunt-crossley\", alpha = 0.3 }\n",
      "stiffness = 3e4\nexponent = 1.5\ndamping = { model = \"hunt-crossley\", restitution = 0.6, "
      "speed = 0.4 }\n",
      "stiffness = 3e4\nexponent = 1.5\ndamping = { model = \"lankarani-nikravesh\", restitution = "
      "0.6, speed = 0.4 }\n",
      "stiffness = 3e4\nexponent = 1.5\ndamping = { model = \"flores\", restitution = 0.6, speed = "
      "0.4 }\n",
      "stiffness = 3e4\nexponent = 1.5\ndamping = { model = \"flores\", restitution = 0.6, speed = "
      "0.4, inversion = \"exact\" }\n"};
  const double x = 0.006, v = 0.3;
  for (const std::string& text : springs) {
    const Scene scene = scene_with(text);
    const auto force = [&](const std::string& name, double value) {
      return assemble(with_parameter(scene, name, value)).stops.front().force().at(x, v);
    };
    int moved = 0;
    for (const std::string& name : parameter_names(scene)) {
      if (name.rfind("stop.spring.", 0) != 0) continue;
      const double here = *find_parameter(scene, name);
      // An exponent of 1 cannot get smaller.
      if (here == 1.0) continue;
      const double h = 1e-3 * here;
      const double meant = (8.0 * (force(name, here + h) - force(name, here - h)) -
                            (force(name, here + 2.0 * h) - force(name, here - 2.0 * h))) /
                           (12.0 * h);
      const System tangent = system_tangent(scene, name);
      const ContactForce law = assemble(scene).stops.front().force();
      EXPECT_NEAR(law.rate_at(x, v, tangent.stops.front().force()), meant,
                  1e-8 * std::abs(meant) + 1e-9)
          << text << name;
      ++moved;
    }
    EXPECT_GE(moved, 1) << text;
  }
}

}  // namespace
}  // namespace graze
