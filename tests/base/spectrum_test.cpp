// Amplitudes and power over the frequency against sinusoids and noise whose power is known.
#include "graze/base/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

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

// A line on a frequency of the spectrum has its power A^2/2 in three frequencies: Hann's window has
// a bandwidth of one and a half of their steps, and a quarter of the peak on either side.
TEST(PowerSpectrum, HasThePowerOfASinusoid) {
  constexpr std::size_t kSegment = 200;
  constexpr double kRate = 50.0, kStep = kRate / kSegment, kAmplitude = 0.7;
  PowerSpectrum spectrum(kSegment, kRate);
  for (int i = 0; i < 199; ++i) spectrum.add(0.0);
  EXPECT_TRUE(spectrum.density().empty());
  PowerSpectrum line(kSegment, kRate);
  for (int i = 0; i < 1000; ++i) line.add(3.0 + kAmplitude * std::cos(kTwoPi * 2.0 * i / kRate));
  // At 0, 100, .., 800.
  EXPECT_EQ(line.segments(), 9);
  const std::vector<double> density = line.density();
  ASSERT_EQ(density.size(), kSegment / 2 + 1);
  const double power = 0.5 * kAmplitude * kAmplitude;
  EXPECT_NEAR(density[8], power / 1.5 / kStep, 1e-12);
  EXPECT_NEAR(density[7], 0.25 * density[8], 1e-12);
  EXPECT_NEAR(density[9], 0.25 * density[8], 1e-12);
  double sum = 0.0;
  for (const double value : density) sum += value * kStep;
  EXPECT_NEAR(sum, power, 1e-12);
  EXPECT_LT(density[0], 1e-24);
  EXPECT_LT(density[40], 1e-24);
}

// Noise of variance s^2 has the density 2 s^2 / rate at all frequencies, to a part of one over the
// root of the number of independent values, some fifty thousand.
TEST(PowerSpectrum, OfWhiteNoiseIsFlat) {
  constexpr double kRate = 8.0, kDeviation = 1.5;
  PowerSpectrum spectrum(128, kRate);
  std::mt19937 random(7);
  std::normal_distribution<double> noise(-2.0, kDeviation);
  for (int i = 0; i < 100'000; ++i) spectrum.add(noise(random));
  const std::vector<double> density = spectrum.density();
  const double level = 2.0 * kDeviation * kDeviation / kRate;
  for (const auto& [from, to] : {std::pair(2, 22), {22, 42}, {42, 63}}) {
    double mean = 0.0;
    for (int k = from; k < to; ++k) mean += density[static_cast<std::size_t>(k)] / (to - from);
    EXPECT_NEAR(mean, level, 0.03 * level);
  }
}

TEST(PowerSpectrum, SegmentsHaveLengthsThatTransformFast) {
  EXPECT_EQ(segment_length(6400.0), 6400U);
  EXPECT_EQ(segment_length(2201.0), 2200U);  // 2^3 5^2 11
  EXPECT_EQ(segment_length(2.0 * 67.0), 132U);
  EXPECT_EQ(segment_length(0.0), 4U);
}

}  // namespace
}  // namespace graze
