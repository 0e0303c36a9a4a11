// Stable orbits that only motions from other starts settle on.
#include "graze/orbit/search/spread_starts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// Two stable (1, 4) orbits coexist with others here; the motion from rest settles on one of them.
constexpr const char* kCoexisting = R"(
[modal]
frequencies = [1.0, 4.868488556304991]
damping_ratios = [0.09704789201894763, 0.015315246975930048]
participation = [1.0, 0.16892174155688267]
[forcing]
kind = "modal"
amplitude = 1.0
frequency = 1.4954596219803933
phase = 2.1660531651199495
[[stop]]
shape = [1.0, -0.6455774821228346]
gap = 0.7580137672626773
side = "above"
restitution = 0.8189853113753269
[[stop]]
shape = [1.0, -0.6455774821228346]
gap = 0.7909521325478488
side = "below"
restitution = 0.8189853113753269
)";

FoundOrbits settled(const FinderOptions& options, long long work) {
  const System system = assemble(parse_scene(kCoexisting, "coexisting"));
  FoundOrbits found;
  add_settled_orbits(system, options, work, found);
  return found;
}

TEST(SpreadStarts, SettleOnOrbitsThatCoexist) {
  // Phases from random starts of `map`, told apart by their impacts.
  const double second[] = {0.190188126, 0.886342215, 3.114969067, 3.772698149};
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    SCOPED_TRACE(seed);
    FinderOptions options;
    options.impacts = 4;
    options.random_seed = seed;
    const FoundOrbits found = settled(options, kSpreadWork);
    EXPECT_EQ(found.orbits.size(), 2u);
    const auto is_second = [&](const Orbit& orbit) {
      if (orbit.impacts.size() != 4) return false;
      for (std::size_t i = 0; i < 4; ++i)
        if (!(std::abs(orbit.impacts[i].phase - second[i]) < 1e-8)) return false;
      return orbit.stable == true;
    };
    EXPECT_EQ(std::count_if(found.orbits.begin(), found.orbits.end(), is_second), 1);
    EXPECT_EQ(found.notes.size(), 1u);
  }
}

TEST(SpreadStarts, AreTheSameOnAnyNumberOfThreads) {
  FinderOptions options;
  options.threads = 1;
  const FoundOrbits one = settled(options, 4096);
  options.threads = 4;
  const FoundOrbits four = settled(options, 4096);
  EXPECT_EQ(one.notes, four.notes);
  ASSERT_EQ(one.orbits.size(), four.orbits.size());
  for (std::size_t i = 0; i < one.orbits.size(); ++i)
    EXPECT_EQ(one.orbits[i].impacts[0].phase, four.orbits[i].impacts[0].phase);
}

}  // namespace
}  // namespace graze
