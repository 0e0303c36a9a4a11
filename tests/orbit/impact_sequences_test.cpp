// Sequences of stops up to rotation.
#include "graze/orbit/search/detail/impact_sequences.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace graze {
namespace {

// Burnside's lemma: (1/k) sum over rotations of n^gcd(k, rotation).
std::size_t necklaces(int n, int k) {
  double sum = 0.0;
  for (int turn = 0; turn < k; ++turn) sum += std::pow(n, std::gcd(k, turn));
  return static_cast<std::size_t>(std::lround(sum / k));
}

TEST(ImpactSequences, AreAsManyAsBurnsideCounts) {
  for (int n = 1; n <= 4; ++n)
    for (int k = 1; k <= 7; ++k) {
      const ImpactSequences all = impact_sequences(n, k, 100'000);
      EXPECT_TRUE(all.complete);
      EXPECT_EQ(all.sequences.size(), necklaces(n, k)) << n << " stops, " << k << " impacts";
    }
}

TEST(ImpactSequences, AreTheSmallestOfTheirRotationsEachOnce) {
  const ImpactSequences all = impact_sequences(3, 6, 100'000);
  std::set<std::vector<int>> seen;
  for (const std::vector<int>& sequence : all.sequences) {
    std::vector<int> turned = sequence;
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      EXPECT_LE(sequence, turned);
    }
    EXPECT_TRUE(seen.insert(sequence).second);
  }
  EXPECT_TRUE(std::is_sorted(all.sequences.begin(), all.sequences.end()));
}

TEST(ImpactSequences, SayWhenSomeAreLeftOut) {
  EXPECT_FALSE(impact_sequences(2, 8, 35).complete);
  EXPECT_EQ(impact_sequences(2, 8, 35).sequences.size(), 35u);
  EXPECT_TRUE(impact_sequences(2, 8, 36).complete);
}

}  // namespace
}  // namespace graze
