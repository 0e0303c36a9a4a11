// Sensitivities of probes against closed forms.
#include "graze/study/compare/sensitivity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graze/base/errors.hpp"
#include "graze/base/even_values.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// A free mass under a constant acceleration g: w = g t^2/2.
Scene falling_mass() {
  return parse_scene(
      "[modal]\nfrequencies = [0.0]\ninertia = [1.0]\n"
      "[gravity]\nacceleration = 2.0\n"
      "[[probe]]\nshape = [1.0]\n[[probe]]\nshape = [1.0]\nquantity = 'velocity'\n",
      "falling.toml");
}

TEST(Sensitivity, OfAFallingMass) {
  SensitivityOptions options;
  options.series.parameter = "gravity.acceleration";
  options.series.values = even_values(1.0, 3.0, 5);
  options.series.duration = 2.0;
  options.reference = 2.0;
  const std::vector<SensitivityCurve> curves = sensitivities(falling_mass(), options);
  ASSERT_EQ(curves.size(), 1u);
  for (int k = 0; k < 5; ++k) {
    const double g = 1.0 + 0.5 * k;
    const ValueRun& run = curves[0].runs[static_cast<std::size_t>(k)];
    EXPECT_EQ(run.value, g);
    EXPECT_NEAR(run.ends[0], 2.0 * g, 1e-14);
    EXPECT_NEAR(run.ends[1], 2.0 * g, 1e-14);
    EXPECT_NEAR(run.peaks[0], 2.0 * g, 1e-14);
    EXPECT_NEAR(curves[0].s1(k, 0), g / 2.0 - 1.0, 1e-14);
    EXPECT_NEAR(curves[0].s2(k, 0), 1.0 - g / 2.0, 1e-14);
  }
}

// Plucked and let go: the largest size is the amplitude, wherever samples fall.
TEST(Sensitivity, PeaksLieBetweenSamples) {
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [1.0]\n[[probe]]\nshape = [1.0]\n[initial]\nq = [0.3]\nqdot = [0.4]\n"
      "[[stop]]\nshape = [1.0]\ngap = 0.8\nrestitution = 0.5\n",
      "plucked.toml");
  RunSeriesOptions options;
  options.parameter = "modal.frequencies.1";
  options.values = {1.0, 2.0};
  options.duration = 7.0;
  const std::vector<ValueRun> runs = run_series(scene, options);
  // Quartics through 20 samples to an oscillation leave (pi/10)^6/720 of the amplitude or so.
  EXPECT_NEAR(runs[0].peaks[0], 0.5, 7e-7);
  EXPECT_NEAR(runs[1].peaks[0], std::hypot(0.3, 0.2), 1e-6);
  EXPECT_TRUE(runs[0].impacts.empty());
}

TEST(Sensitivity, ValuesOfAnotherParameterAndThreads) {
  SensitivityOptions options;
  options.series.parameter = "gravity.acceleration";
  options.series.values = even_values(1.0, 3.0, 9);
  options.series.duration = 1.0;
  options.reference = 2.0;
  options.second = "modal.inertia.1";
  options.seconds = {1.0, 4.0};
  options.series.threads = 1;
  const auto alone = sensitivities(falling_mass(), options);
  options.series.threads = 4;
  const auto together = sensitivities(falling_mass(), options);
  ASSERT_EQ(alone.size(), 2u);
  EXPECT_NEAR(alone[1].runs[0].ends[0], 2.0, 1e-14);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(alone[c].s1, together[c].s1);
    EXPECT_EQ(alone[c].s2, together[c].s2);
  }
}

TEST(Sensitivity, RefusesWhatTheSceneDoesNotAllow) {
  RunSeriesOptions options;
  options.parameter = "gravity.size";
  options.values = {1.0};
  options.duration = 1.0;
  EXPECT_THROW(run_series(falling_mass(), options), InputError);
}

}  // namespace
}  // namespace graze
