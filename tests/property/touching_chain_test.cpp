// Bodies in a row that touch at rest, on springs of every exponent and damping: against an
// independent integration of them.
#include "property/scene_property.hpp"
#include "support/chain_reference.hpp"

namespace graze {
namespace {

TEST(RandomChain, TouchingBodiesMoveAsIntegrated) {
  // One takes as long as some ten other scenes.
  const std::uint64_t chains = property::from_environment("GRAZE_SCENES", 100) / 10;
  const std::uint64_t seed = property::from_environment("GRAZE_SEED", 1);
  for (std::uint64_t i = 0; i < chains; ++i) {
    support::Dice dice(1000000 * seed + i);
    const support::Chain chain = support::touching_chain(dice, 20);
    SimulationOptions options = support::for_seconds(chain.duration);
    options.energy = true;
    const auto run = support::record_run(chain.system, chain.start, options);
    ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << i << ": " << run.result.message;
    // The integration errs by some hundred tolerances.
    const State expected = support::integrated_chain(chain);
    EXPECT_LT((run.result.final.q - expected.q).cwiseAbs().maxCoeff(), 1e-8) << i;
    EXPECT_LT((run.result.final.qdot - expected.qdot).cwiseAbs().maxCoeff(), 1e-8) << i;
    EXPECT_LT(run.result.totals.energy_added, 1e-12) << i;
  }
}

}  // namespace
}  // namespace graze
