// Scenes without units, and frequencies in Hz.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "graze/scene/difference.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

std::string scene_text(const std::string& frequency, const std::string& head = "") {
  return head +
         "[modal]\nfrequencies = [1.0]\nparticipation = [1.0]\n[forcing]\namplitude = 1.0\n" +
         frequency + "\n[[stop]]\nshape = [1.0]\ngap = 0.5\nrestitution = 0.8\n";
}

Scene scene_with(const std::string& frequency, const std::vector<std::string>& settings = {}) {
  return parse_scene(scene_text(frequency), "s", settings);
}

// 4.5 Hz are 9 pi rad/s.
TEST(FrequencyInHertz, IsThatManyTurnsASecond) {
  EXPECT_DOUBLE_EQ(scene_with("frequency_hz = 4.5").forcing->frequency, 9.0 * std::numbers::pi);
  EXPECT_EQ(scene_with("frequency = 4.5").forcing->frequency, 4.5);
}

TEST(FrequencyInHertz, IsWrittenAsItWasRead) {
  const std::string text = write_scene(scene_with("frequency_hz = 4.7"));
  EXPECT_NE(text.find("\nfrequency_hz = 4.7\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("\nfrequency = "), std::string::npos) << text;
  EXPECT_EQ(write_scene(parse_scene(text, "t")), text);
}

TEST(FrequencyInHertz, ReplacesTheOneInTheOtherUnit) {
  const Scene hertz = scene_with("frequency = 4.5", {"forcing.frequency_hz=0.5"});
  EXPECT_DOUBLE_EQ(hertz.forcing->frequency, std::numbers::pi);
  EXPECT_NE(write_scene(hertz).find("frequency_hz = 0.5"), std::string::npos);
  const Scene angular = scene_with("frequency_hz = 4.5", {"forcing.frequency=3"});
  EXPECT_EQ(angular.forcing->frequency, 3.0);
  EXPECT_EQ(write_scene(angular).find("frequency_hz"), std::string::npos);
}

// Either name is a parameter, whichever the scene has.
TEST(FrequencyInHertz, IsAParameterOfEveryScene) {
  for (const char* written : {"frequency = 6.0", "frequency_hz = 0.95"}) {
    const Scene scene = scene_with(written);
    const double angular = scene.forcing->frequency;
    EXPECT_DOUBLE_EQ(*parameter_value(scene, "forcing.frequency"), angular);
    EXPECT_DOUBLE_EQ(*parameter_value(scene, "forcing.frequency_hz"), angular / kTwoPi);
    EXPECT_DOUBLE_EQ(with_parameter(scene, "forcing.frequency_hz", 0.25).forcing->frequency,
                     kTwoPi / 4.0);
    EXPECT_EQ(with_parameter(scene, "forcing.frequency", 0.25).forcing->frequency, 0.25);
    EXPECT_DOUBLE_EQ(parameter_direction(scene, "forcing.frequency_hz").forcing->frequency, kTwoPi);
    EXPECT_EQ(parameter_direction(scene, "forcing.frequency").forcing->frequency, 1.0);
    EXPECT_EQ(parameter_unit(scene, "forcing.frequency_hz"), "Hz");
    EXPECT_EQ(parameter_unit(scene, "forcing.frequency"), "rad/s");
  }
  EXPECT_FALSE(
      parameter_value(parse_scene("[modal]\nfrequencies = [1.0]\n", "s"), "forcing.frequency_hz"));
}

TEST(FrequencyInHertz, MakesNoOtherScene) {
  const Scene hertz = scene_with("frequency_hz = 0.5"),
              angular = scene_with("frequency = " + std::to_string(std::numbers::pi));
  EXPECT_NE(scene_difference(hertz, angular, {}), "");  // 3.141593 is not pi
  EXPECT_EQ(scene_difference(hertz, angular, {"forcing.frequency_hz"}), "");
  EXPECT_EQ(scene_difference(hertz, hertz, {}), "");
}

TEST(UnitsNone, LeavesParametersWithoutUnit) {
  const Scene scene = parse_scene(scene_text("frequency = 0.8", "units = \"none\"\n"), "s");
  for (const std::string& name : parameter_names(scene))
    EXPECT_EQ(parameter_unit(scene, name), "") << name;
  const std::vector<std::string> names = parameter_names(scene);
  EXPECT_NE(std::find(names.begin(), names.end(), "stop.gap"), names.end());
  EXPECT_FALSE(parameter_value(scene, "forcing.frequency_hz"));
  EXPECT_THROW(with_parameter(scene, "forcing.frequency_hz", 0.1), InputError);
  EXPECT_EQ(parameter_unit(scene_with("frequency = 0.8"), "stop.gap"), "m");
}

TEST(UnitsNone, IsWrittenWhereItIsGiven) {
  EXPECT_EQ(write_scene(parse_scene(scene_text("frequency = 0.8", "units = \"none\"\n"), "s"))
                .rfind("units = \"none\"\n", 0),
            0U);
  EXPECT_EQ(write_scene(scene_with("frequency = 0.8")).find("units"), std::string::npos);
}

}  // namespace
}  // namespace graze
