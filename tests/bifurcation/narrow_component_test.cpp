// Components narrower than the distance of the start values. The numbers are those of an
// independent scan of |kappa(Omega)| = gap: the four-mode paper beam under the momentum law at gap
// 5 mm has 34 folds of (1,1) solutions for Omega in [20, 40], the first at 22.231388, and none at
// all between 30.835599 and 30.854859.
#include <gtest/gtest.h>

#include <algorithm>

#include "graze/bifurcation/orbit_branches.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

OrbitBranches traced(double max_step) {
  const Scene scene = read_scene(GRAZE_SOURCE_DIR "/data/scenes/05_wagg_one_mode.toml",
                                 {"beam.modes=4", "stop.gap=5e-3"});
  const SystemFamily family(scene, "forcing.frequency");
  BranchOptions options;
  options.from = 20.0;
  options.to = 40.0;
  options.max_step = max_step;
  options.keep_virtual = true;
  options.finder.from_simulation = options.finder.from_random = false;
  return trace_orbits(family, options);
}

TEST(NarrowComponents, AllFoldsAreFoundOnceWhateverTheStep) {
  for (const double max_step : {0.0, 0.05, 2.0}) {
    std::vector<double> folds;
    for (const OrbitBranch& branch : traced(max_step).branches)
      for (const SpecialPoint& special : branch.special)
        if (special.kind == SpecialKind::kFold) folds.push_back(special.at.value);
    std::sort(folds.begin(), folds.end());
    ASSERT_EQ(folds.size(), 34u) << max_step;
    EXPECT_NEAR(folds.front(), 22.231388, 1e-6);
    for (std::size_t i = 1; i < folds.size(); ++i) EXPECT_GT(folds[i] - folds[i - 1], 1e-6);
  }
}

TEST(NarrowComponents, NothingIsTracedAcrossTheGapWithoutSolutions) {
  for (const OrbitBranch& branch : traced(2.0).branches)
    for (const OrbitBranchPoint& point : branch.points)
      EXPECT_FALSE(point.value > 30.835599 + 1e-6 && point.value < 30.854859 - 1e-6);
}

}  // namespace
}  // namespace graze
