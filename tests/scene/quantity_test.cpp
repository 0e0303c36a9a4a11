// Numbers of a scene that are written with a unit of their own.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "graze/base/errors.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

constexpr double kPi = std::numbers::pi;

std::string beam_with_units(const std::string& more) {
  return "[beam]\nlength = \"300 mm\"\nyoungs_modulus = \"205 GPa\"\nsecond_moment = \"0.244 "
         "mm^4\"\n"
         "density = \"8.5 g/cm^3\"\narea = \"12.4 mm²\"\nmodes = 2\n" +
         more;
}

constexpr const char* kStopWithUnits =
    "[[stop]]\nposition = 0.3\ngap = \"1.05 mm\"\nrestitution = \"80 %\"\n";

std::string refusal_of_units(const std::string& text) {
  try {
    parse_scene(text, "s");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// Decimal prefixes move the point and round nothing.
TEST(Quantities, AreTheNumberThatIsReadWithoutAUnit) {
  const Scene scene = parse_scene(beam_with_units(kStopWithUnits), "s");
  EXPECT_EQ(scene.beam()->length, 0.3);
  EXPECT_EQ(scene.beam()->youngs_modulus, 205e9);
  EXPECT_EQ(*scene.beam()->second_moment, 0.244e-12);
  EXPECT_DOUBLE_EQ(scene.beam()->density, 8500.0);
  EXPECT_EQ(*scene.beam()->area, 12.4e-6);
  EXPECT_EQ(scene.stops[0].gap, 1.05e-3);
  EXPECT_EQ(scene.stops[0].restitution, std::vector<double>{0.8});
}

// A pound is 0.45359237 kg, an inch 25.4 mm, g_n 9.80665 m/s^2, all exactly.
TEST(Quantities, MayBeInOtherUnitsOfTheSameKind) {
  const auto with = [](const std::string& setting) {
    return parse_scene(
        beam_with_units(kStopWithUnits + std::string("[forcing]\namplitude = \"0.6 mm\"\nfrequency "
                                                     "= \"4.5 Hz\"\nphase = \"90 deg\"\n")),
        "s", {setting});
  };
  const Scene scene = with("stop.gap=\"-0.5 in\"");
  EXPECT_DOUBLE_EQ(scene.stops[0].gap, -0.0127);
  EXPECT_EQ(scene.forcing->amplitude, 0.6e-3);
  EXPECT_DOUBLE_EQ(scene.forcing->frequency, 9.0 * kPi);
  EXPECT_DOUBLE_EQ(scene.forcing->phase, 0.5 * kPi);
  EXPECT_DOUBLE_EQ(with("forcing.frequency=\"270 rpm\"").forcing->frequency, 9.0 * kPi);
  EXPECT_DOUBLE_EQ(with("beam.youngs_modulus=\"1 psi\"").beam()->youngs_modulus,
                   0.45359237 * 9.80665 / (0.0254 * 0.0254));
  EXPECT_DOUBLE_EQ(with("beam.density=\"490 lb/ft^3\"").beam()->density,
                   490.0 * 0.45359237 / std::pow(0.3048, 3));
}

// The unit of a stiffness depends on the exponent, wherever that stands.
TEST(Quantities, OfASpringHaveTheUnitOfItsExponent) {
  const auto spring = [](const std::string& keys) {
    return beam_with_units("[[stop]]\nposition = 0.3\ngap = 0.0\n[stop.spring]\n" + keys);
  };
  EXPECT_EQ(
      parse_scene(spring("stiffness = \"7 N/mm\"\nexponent = 1"), "s").stops[0].spring->stiffness,
      7e3);
  EXPECT_DOUBLE_EQ(parse_scene(spring("stiffness = \"1 N/mm^1.5\"\nexponent = 1.5"), "s")
                       .stops[0]
                       .spring->stiffness,
                   std::pow(10.0, 4.5));
  EXPECT_NE(
      refusal_of_units(spring("stiffness = \"7 N/mm\"\nexponent = 1.5")).find("N/mm is not a unit"),
      std::string::npos);
  EXPECT_NE(refusal_of_units(spring("stiffness = \"7 N/m\"\nexponent = 1.37")), "");
}

TEST(Quantities, ThatCannotBeMeantSayWhy) {
  const auto gap = [](const std::string& text) {
    return refusal_of_units(
        beam_with_units("[[stop]]\nposition = 0.3\ngap = \"" + text + "\"\nrestitution = 0.8\n"));
  };
  EXPECT_EQ(gap("1 mmm"),
            "s:10:1: stop.gap: the string \"1 mmm\" is not allowed: there is no unit \"mmm\", did "
            "you mean mm?");
  EXPECT_NE(gap("1 N").find("N is not a unit of what is measured in m"), std::string::npos);
  EXPECT_NE(gap("1").find("it has no unit, write \"1 m\""), std::string::npos);
  EXPECT_NE(gap("1 mm/s m").find("could multiply or divide"), std::string::npos);
  EXPECT_NE(gap("wide").find("it must be a number in m"), std::string::npos);
  EXPECT_NE(refusal_of_units("units = \"none\"\n" + beam_with_units(kStopWithUnits))
                .find("it must be a number"),
            std::string::npos);
  EXPECT_NE(refusal_of_units(
                beam_with_units("[[stop]]\nposition = 0.3\ngap = 0.0\nrestitution = \"0.8 m\"\n"))
                .find("it is a pure number and has no m"),
            std::string::npos);
}

TEST(Quantities, AreWrittenInSiUnits) {
  const std::string text = write_scene(parse_scene(beam_with_units(kStopWithUnits), "s"));
  EXPECT_NE(text.find("gap = 0.00105\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace graze
