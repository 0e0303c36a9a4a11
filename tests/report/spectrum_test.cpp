// Amplitudes over the frequency against sinusoids whose amplitudes are known.
#include "graze/report/chart/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace graze {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

// Two sinusoids of 5 and 12 whole periods in the span, and a constant.
TEST(AmplitudeSpectrum, HasTheAmplitudesOfSinusoids) {
  constexpr int kCount = 1000;
  constexpr double kRate = 250.0;  // 4 s
  std::vector<double> values;
  for (int i = 0; i < kCount; ++i) {
    const double t = i / kRate;
    values.push_back(3.0 + 0.7 * std::cos(kTwoPi * 1.25 * t + 0.3) +
                     1e-3 * std::sin(kTwoPi * 3.0 * t));
  }
  const Spectrum spectrum = amplitude_spectrum(values, kRate);
  ASSERT_EQ(spectrum.frequency.size(), 499U);
  EXPECT_DOUBLE_EQ(spectrum.frequency[4], 1.25);
  EXPECT_NEAR(spectrum.amplitude[4], 0.7, 1e-13);
  // Hann's window: half of it on either side.
  EXPECT_NEAR(spectrum.amplitude[3], 0.35, 1e-13);
  EXPECT_NEAR(spectrum.amplitude[5], 0.35, 1e-13);
  EXPECT_DOUBLE_EQ(spectrum.frequency[11], 3.0);
  EXPECT_NEAR(spectrum.amplitude[11], 1e-3, 1e-13);
  EXPECT_LT(spectrum.amplitude[8], 1e-14);
}

TEST(AmplitudeSpectrum, NeedsSamples) {
  EXPECT_TRUE(amplitude_spectrum({}, 1.0).frequency.empty());
  EXPECT_TRUE(amplitude_spectrum({1.0, 2.0, 3.0}, 1.0).frequency.empty());
}

}  // namespace
}  // namespace graze
