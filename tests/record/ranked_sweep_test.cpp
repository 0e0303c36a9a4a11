// A sweep whose blocks are shared by ranks, which know each other's rows as text alone: the rows of
// one process, to the last digit.
#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <vector>

#include "graze/record/file/journal.hpp"
#include "graze/scene/reader.hpp"
#include "graze/study/sweep/sweep.hpp"
#include "support/rank_threads.hpp"

namespace graze {
namespace {

// Upwards two attractors coexist, so that blocks are run again from what the one before hands on
// (docs/decisions/0049).
SystemFamily bistable_family() {
  return SystemFamily(read_scene(GRAZE_SOURCE_DIR "/data/scenes/04_impact_oscillator.toml",
                                 {"forcing.frequency=1.6", "stop.gap=0.5", "initial.q=[0.0]"}),
                      "forcing.amplitude");
}

Sweep swept(const SystemFamily& family, SweepDirection direction, BlockWorkers& workers,
            PieceStore* store) {
  SweepOptions options;
  options.from = 0.1;
  options.to = 1.0;
  options.points = 70;
  options.direction = direction;
  options.threads = 1;
  options.workers = &workers;
  options.memory = memory_in<SweepRow>(store);
  return sweep(family, options);
}

std::vector<std::string> texts(const Sweep& sweep) {
  std::vector<std::string> list;
  for (const SweepRow& row : sweep.rows) list.push_back(piece_text(row));
  return list;
}

TEST(RankedSweep, HasTheRowsOfOneProcess) {
  const SystemFamily family = bistable_family();
  for (const SweepDirection direction : {SweepDirection::kUp, SweepDirection::kFresh}) {
    const Sweep alone = swept(family, direction, own_threads(), nullptr);
    ASSERT_EQ(alone.rows.size(), 70U);
    EXPECT_EQ(alone.run_again > 4, direction == SweepDirection::kUp) << alone.run_again;
    for (const int ranks : {1, 2, 3}) {
      SCOPED_TRACE(ranks);
      run_ranks(
          ranks,
          [&](FirstRank& workers, std::atomic<bool>&) {
            const Sweep shared =
                swept(family, direction, workers, workers.begin("a sweep", "", nullptr));
            EXPECT_EQ(texts(shared), texts(alone));
            EXPECT_EQ(shared.run_again, alone.run_again);
            EXPECT_EQ(shared.stopped, StopReason::kNone);
          },
          [&](int, OtherRank& workers, std::atomic<bool>&) {
            const SystemFamily own = bistable_family();
            swept(own, direction, workers, workers.begin("a sweep", "", nullptr));
          });
    }
  }
}

}  // namespace
}  // namespace graze
