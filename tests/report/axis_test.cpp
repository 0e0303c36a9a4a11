#include "graze/report/chart/axis.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

TEST(AxisUnit, KeepsNumbersShort) {
  const auto expect_unit = [](const char* si, double largest, const char* unit, double factor) {
    EXPECT_EQ(axis_unit(si, largest).unit, unit);
    EXPECT_DOUBLE_EQ(axis_unit(si, largest).factor, factor);
  };
  expect_unit("N", 0.1, "mN", 1e3);
  expect_unit("N", 3.0, "N", 1.0);
  expect_unit("J", 4e-5, "µJ", 1e6);
  expect_unit("J", 0.1, "mJ", 1e3);
  expect_unit("m", 1.05e-3, "mm", 1e3);
  expect_unit("m", 2e-14, "10^{-15} m", 1e15);
}

TEST(ParameterTitle, NamesTheQuantityAndWhichOfSeveral) {
  EXPECT_EQ(parameter_title("stop.spring.stiffness"), "stiffness k");
  EXPECT_EQ(parameter_title("stop.2.spring.stiffness"), "stiffness k, stop 2");
  EXPECT_EQ(parameter_title("modal.frequencies.3"), "natural frequency ω of mode 3");
  EXPECT_EQ(parameter_title("beam.piece.2.section.height.1"), "height of the section 1, piece 2");
  EXPECT_EQ(parameter_title("initial.q.2"), "q_{2} at the start");
}

TEST(ParameterTitle, IsThePathOfNoParameterOfTheScenes) {
  for (const auto& file :
       std::filesystem::directory_iterator(std::string(GRAZE_SOURCE_DIR) + "/data/scenes")) {
    if (file.path().extension() != ".toml") continue;
    for (const std::string& name : parameter_names(read_scene(file.path())))
      EXPECT_NE(parameter_title(name), as_markup(name)) << file.path();
  }
}

}  // namespace
}  // namespace graze
