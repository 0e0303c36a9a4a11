// Stops whose stiffness is that of the modes left out: rest against them has no error of the
// truncation, whatever the number of modes; what is refused.
#include "graze/assembly/detail/residual_springs.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/errors.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"
#include "support/differences.hpp"
#include "support/scratch_folder.hpp"

namespace graze {
namespace {

constexpr double kPi = std::numbers::pi;
const std::string kBeam =
    "[beam]\nlength = 2.0\nyoungs_modulus = 6.0\nsecond_moment = 0.5\ndensity = 2.0\narea = 0.25\n";
constexpr double kTip = 3.0 * 3.0 / 8.0;  // 3 E I/L^3

std::string stop(double x, double gap, const char* side) {
  return fmt::format(
      "[[stop]]\nposition = {:.17g}\ngap = {:.17g}\nside = \"{}\"\n[stop.spring]\n"
      "stiffness = \"residual\"\n",
      x, gap, side);
}

Scene scene_of(const std::string& text) { return parse_scene(text, "test.toml"); }

double force_at_rest(const Scene& scene, std::size_t which) {
  const System system = assemble(scene);
  const State rest = initial_state(scene, system);
  const Stop& at = system.stops[which];
  return at.force().at(at.row.dot(rest.q) - at.gap, 0.0);
}

std::string refusal(const std::function<Scene()>& scene) {
  try {
    assemble(scene());
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// The tip pressed aside by 0.1: F = 3 E I/L^3 times that.
TEST(ResidualSpring, HoldsWhatTheWholeBeamWould) {
  for (const int modes : {1, 2, 5})
    for (const char* side : {"above", "below"})
      EXPECT_NEAR(
          force_at_rest(
              scene_of(kBeam + fmt::format("modes = {}\n", modes) + stop(2.0, -0.1, side)), 0) /
              (0.1 * kTip),
          1.0, 1e-12)
          << modes << side;
}

// Under its weight the tip goes down by rho A g L^4/(8 E I); what the modes leave out of that moves
// the gap.
TEST(ResidualSpring, MeetsTheWholeBeamUnderItsWeight) {
  const double sag = 0.5 * 0.3 * 16.0 / (8.0 * 3.0);
  for (const int modes : {1, 2, 5})
    for (const auto& [side, down] : {std::pair{"below", 1.0}, {"above", -1.0}}) {
      const Scene scene =
          scene_of(kBeam + fmt::format("modes = {}\n[gravity]\nacceleration = -0.3\n", modes) +
                   stop(2.0, -0.25, side));
      EXPECT_NEAR(force_at_rest(scene, 0) / ((0.25 + down * sag) * kTip), 1.0, 1e-12)
          << modes << side;
    }
}

// Two stops that press at once, R = G - sum: their forces are known but for what couples them.
TEST(ResidualSpring, OfSeveralStopsIsTheDiagonal) {
  const std::string string =
      "[string]\nlength = 1.0\ntension = 4.0\nmass_per_length = 0.1\nmodes = 60\n";
  const Scene scene = scene_of(string + stop(0.3, 0.1, "above") + stop(0.7, 0.1, "above"));
  const std::vector<ResidualSpring> springs = residual_springs(scene, modal_model(scene));
  double left = 0.3 * 0.7 / 4.0;
  for (int j = 1; j <= 60; ++j) {
    const double sine = std::sin(j * kPi * 0.3);
    left -= 2.0 * sine * sine / (4.0 * j * j * kPi * kPi);
  }
  for (const ResidualSpring& spring : springs) EXPECT_NEAR(spring.stiffness * left, 1.0, 1e-10);
}

TEST(ResidualSpring, OfMatricesIsTheRestOfTheirModes) {
  const ScratchFolder folder;
  const auto write = [&](const char* name, const std::string& entries) {
    std::ofstream(folder / name) << "%%MatrixMarket matrix coordinate real symmetric\n" << entries;
  };
  write("m.mtx", "2 2 2\n1 1 1.0\n2 2 1.0\n");
  write("k.mtx", "2 2 3\n1 1 2.0\n2 1 -1.0\n2 2 2.0\n");
  const auto scene = [&](int modes, const std::string& stops) {
    return parse_scene(fmt::format("[matrices]\nmass = \"m.mtx\"\nstiffness = \"k.mtx\"\n"
                                   "modes = {}\n",
                                   modes) +
                           stops,
                       (folder / "scene.toml").string());
  };
  const std::string at =
      "[[stop]]\nnode = \"1\"\ngap = 0.1\n[stop.spring]\nstiffness = "
      "\"residual\"\n";
  // The second mode, w^2 = 3, phi^2 = 1/2, is left out.
  EXPECT_NEAR(assemble(scene(1, at)).stops[0].force().stiffness, 6.0, 1e-12);
  const std::string said = refusal([&] { return scene(2, at); });
  EXPECT_NE(said.find("the flexibility that the 2 modes leave out at the stop, "),
            std::string::npos)
      << said;
  // Either body of a slot may be named first.
  const auto slot = [](const char* node, const char* against) {
    return fmt::format(
        "[[stop]]\nnode = \"{}\"\nagainst = \"{}\"\ngap = 0.1\n[stop.spring]\n"
        "stiffness = \"residual\"\n",
        node, against);
  };
  EXPECT_NO_THROW(assemble(scene(1, slot("1", "2") + slot("2", "1"))));
}

TEST(ResidualSpring, HasRates) {
  const Scene scene =
      scene_of(kBeam + "modes = 3\n[gravity]\nacceleration = -0.3\n" + stop(1.9, 0.1, "below"));
  for (const char* name : {"beam.length", "beam.youngs_modulus", "beam.density", "stop.position",
                           "stop.gap", "gravity.acceleration"}) {
    const auto at = [&](double p) {
      const Stop made = assemble(with_parameter(scene, name, p)).stops[0];
      return Vector{{made.force().stiffness, made.gap}};
    };
    const double value = *find_parameter(scene, name);
    const Vector difference = support::central_difference(at, value, 2e-4 * std::abs(value));
    const Stop rate = system_tangent(scene, name).stops[0];
    const double scale = std::abs(difference[0]) + at(value)[0] / std::abs(value);
    EXPECT_NEAR(rate.force().stiffness, difference[0], 1e-7 * scale) << name;
    EXPECT_NEAR(rate.gap, difference[1], 1e-8) << name;
    EXPECT_EQ(rate.force().exponent, 0.0);
  }
}

TEST(ResidualSpring, StaysAWordInTheScene) {
  const Scene scene = scene_of(kBeam + "modes = 3\n" + stop(1.9, 0.1, "below"));
  const std::string text = write_scene(scene);
  EXPECT_NE(text.find("stiffness = \"residual\""), std::string::npos) << text;
  EXPECT_EQ(text.find("exponent"), std::string::npos) << text;
  EXPECT_EQ(write_scene(scene_of(text)), text);
  EXPECT_EQ(find_parameter(scene, "stop.spring.stiffness"), nullptr);
  EXPECT_EQ(find_parameter(scene, "stop.spring.exponent"), nullptr);
}

// Damping that is built from the stiffness: C = 2 zeta sqrt(k m).
TEST(ResidualSpring, MayBeDamped) {
  const Scene scene = scene_of(kBeam + "modes = 3\n" + stop(2.0, 0.1, "above") +
                               "damping = { model = \"kelvin-voigt\", ratio = 0.1, mass = 0.3 }\n");
  const ContactForce force = assemble(scene).stops[0].force();
  EXPECT_EQ(force.exponent, 1.0);
  EXPECT_NEAR(force.coefficient / (0.2 * std::sqrt(force.stiffness * 0.3)), 1.0, 1e-15);
}

void expect_refused(const std::string& text, const std::string& words) {
  const std::string said = refusal([&] { return scene_of(text); });
  EXPECT_NE(said.find(words), std::string::npos) << said;
}

TEST(ResidualSpring, IsRefusedWhereItIsNotKnown) {
  const std::string tip = stop(2.0, 0.1, "above");
  expect_refused(kBeam + "modes = 3\n" + stop(1.8, 0.1, "above") + tip,
                 "couple stops 1 and 2 by 0.");
  expect_refused(kBeam + "modes = 3\n" + tip + tip, "couple stops 1 and 2 by 1;");
  // Below its own gap the beam would touch both.
  expect_refused(kBeam + "modes = 3\n" + tip + stop(2.0, -0.2, "below"),
                 "couple stops 1 and 2 by 1;");
  EXPECT_NO_THROW(assemble(scene_of(kBeam + "modes = 3\n" + tip + stop(2.0, 0.1, "below"))));
  const std::string rigid = "[[stop]]\nposition = 1.8\ngap = 0.1\nrestitution = 0.5\n";
  expect_refused(kBeam + "modes = 3\n" + rigid + tip,
                 "stop.2.spring.stiffness: \"residual\" is not allowed, the modes left out couple");
  expect_refused(kBeam + "modes = 3\n" + tip + rigid,
                 "stop.spring.stiffness: \"residual\" is not allowed, the modes left out couple");
  expect_refused(kBeam + "modes = 1\nends = [\"free\", \"free\"]\n" + stop(0.3, 0.1, "above"),
                 "the structure is free to make 2 rigid motions");
  expect_refused(
      "[string]\nlength = 2.0\nfrequencies = [3.0, 6.1]\nmass_per_length = 0.5\n"
      "modes = 2\n" +
          stop(0.5, 0.1, "above"),
      "of a string with given frequencies nothing but its modes is known");
  expect_refused(
      "[modal]\nfrequencies = [1.0]\n[[stop]]\nshape = [1.0]\ngap = 1.0\n[stop.spring]\n"
      "stiffness = \"residual\"\n",
      "stop.spring.stiffness: of a [modal] structure nothing but its modes is known");
  expect_refused(kBeam + "modes = 3\n[hub]\nradius = 0.1\ninertia = 1.0\n" + tip,
                 "not known of a beam that turns with a hub");
  expect_refused(kBeam + "modes = 3\n" + tip + "exponent = 1.0\n",
                 "must be left out with \"residual\"");
  expect_refused(kBeam +
                     "modes = 3\n[[stop]]\nposition = 2.0\ngap = 0.1\n[stop.spring]\n"
                     "stiffness = \"stiff\"\n",
                 "stop.spring.stiffness: the string \"stiff\" is not allowed, it must be a number "
                 "greater than 0, in N/m^exponent or \"residual\"");
}

}  // namespace
}  // namespace graze
