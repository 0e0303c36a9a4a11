// Counts and exceeded values of samples whose distribution is known.
#include "graze/base/histogram.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

namespace graze {
namespace {

constexpr int kCount = 100'000;
const double kShares[] = {0.001, 0.01, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99, 0.999};

// A sine is above A cos(pi p) for the share p of the time.
TEST(Histogram, OfASineExceedsWhatItsArcSays) {
  for (const double offset : {0.0, -3.0, 1e6}) {
    Histogram histogram;
    for (int i = 0; i < kCount; ++i)
      histogram.add(offset + 0.4 * std::sin(2.0 * std::numbers::pi * (i + 0.5) / kCount));
    for (const double share : kShares)
      EXPECT_NEAR(histogram.exceeded(share), offset + 0.4 * std::cos(std::numbers::pi * share),
                  1e-3 * 0.8)
          << share;
  }
}

// In whatever order they come.
TEST(Histogram, OfEvenValuesInDisorder) {
  std::vector<double> values(kCount);
  for (int i = 0; i < kCount; ++i) values[static_cast<std::size_t>(i)] = (i + 0.5) / kCount;
  std::shuffle(values.begin(), values.end(), std::mt19937(3));
  Histogram histogram;
  for (const double value : values) histogram.add(value);
  for (const double share : kShares) EXPECT_NEAR(histogram.exceeded(share), 1.0 - share, 5e-4);
  // No count is moved: bins of 2^-4, 6250 values each.
  const BinCounts bins = histogram.from_zero(16);
  ASSERT_EQ(bins.width, 0.0625);
  ASSERT_EQ(bins.counts.size(), 16U);
  for (const long long count : bins.counts) EXPECT_EQ(count, 6250);
}

TEST(Histogram, GrowsOverAllSizes) {
  Histogram histogram;
  double largest = 0.0;
  for (int power = -300; power <= 300; power += 3) {
    histogram.add(std::pow(10.0, power));
    histogram.add(-std::pow(10.0, power));
    largest = std::pow(10.0, power);
  }
  EXPECT_EQ(histogram.count(), 402);
  EXPECT_EQ(histogram.exceeded(0.0), largest);
  EXPECT_EQ(histogram.exceeded(1.0), -largest);
}

TEST(Histogram, ReachesToTheLargestDoubles) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  Histogram histogram;
  for (const double value : {-kLargest, kLargest, 0.0, 1.0}) histogram.add(value);
  EXPECT_EQ(histogram.exceeded(0.0), kLargest);
  EXPECT_EQ(histogram.exceeded(1.0), -kLargest);
  EXPECT_NEAR(histogram.exceeded(0.5) / kLargest, 0.0, 1e-3);
}

TEST(Histogram, OfOneValueIsThatValue) {
  Histogram histogram;
  EXPECT_TRUE(std::isnan(histogram.exceeded(0.5)));
  EXPECT_TRUE(histogram.from_zero(8).counts.empty());
  for (int i = 0; i < 5; ++i) histogram.add(0.3);
  histogram.add(std::numeric_limits<double>::quiet_NaN());
  for (const double share : kShares) EXPECT_EQ(histogram.exceeded(share), 0.3);
  const BinCounts bins = histogram.from_zero(8);
  // [0.25, 0.3125)
  EXPECT_EQ(bins.width, 0.0625);
  EXPECT_EQ(bins.counts, (std::vector<long long>{0, 0, 0, 0, 5}));
  // Hardly another one.
  histogram.add(std::nextafter(0.3, 1.0));
  EXPECT_EQ(histogram.from_zero(8).counts, (std::vector<long long>{0, 0, 0, 0, 6}));
}

}  // namespace
}  // namespace graze
