// What is said where no branch was traced.
#include <gtest/gtest.h>

#include "graze/record/records.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

BranchOptions over_restitution() {
  BranchOptions options;
  options.from = 0.0;
  options.to = 1.0;
  return options;
}

bool speaks_of_penetration(const OrbitBranches& traced) {
  const Outcome outcome = branch_outcome(traced, over_restitution());
  EXPECT_EQ(outcome.name, "no_orbit");
  return outcome.message.find("penetrates") != std::string::npos;
}

TEST(BranchOutcome, SpeaksOfVirtualSolutionsOnlyWhereSomeWereMet) {
  OrbitBranches traced;
  EXPECT_FALSE(speaks_of_penetration(traced));
  traced.starts = 54;
  EXPECT_FALSE(speaks_of_penetration(traced));
  EXPECT_NE(branch_outcome(traced, over_restitution()).message.find("none of 54 starts"),
            std::string::npos);
  traced.virtual_starts = 1;
  EXPECT_TRUE(speaks_of_penetration(traced));
}

// Every (1, 1) solution of this oscillator impacts at negative speed, whatever the restitution; a
// stop that is never met has none.
TEST(BranchOutcome, CountsTheVirtualSolutionsItSpeaksOf) {
  for (const auto& [gap, is_met] : {std::pair{"0.3", true}, {"30", false}}) {
    SCOPED_TRACE(gap);
    const Scene scene =
        support::shipped_scene("04_impact_oscillator", {std::string("stop.gap=") + gap});
    const OrbitBranches traced =
        trace_orbits(SystemFamily(scene, "stop.restitution"), over_restitution());
    EXPECT_TRUE(traced.branches.empty());
    EXPECT_EQ(traced.virtual_starts > 0, is_met);
    EXPECT_EQ(speaks_of_penetration(traced), is_met);
  }
}

}  // namespace
}  // namespace graze
