// Components narrower than any distance of samples, and gaps between them as narrow: none is passed
// over and none is jumped to, whatever the step.
//
// The folds of the four-mode paper beam are those of an independent scan of |kappa(Omega)| = gap:
// under the momentum law at gap 5 mm there are 34 of (1,1) solutions for Omega in [20, 40], the
// first at 22.231388, and no solutions at all between 30.835599 and 30.854859.
//
// The folds of an oscillator that is hardly damped are computed here, from
// y- = (I - E J)^-1 (I - E) (A, i Omega A), |y-_1| = gap, in extended precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/scene/reader.hpp"
#include "impacting_oscillator.hpp"

namespace graze {
namespace {

OrbitBranches traced(const Scene& scene, double from, double to, double max_step) {
  const SystemFamily family(scene, "forcing.frequency");
  BranchOptions options;
  options.from = from;
  options.to = to;
  options.max_step = max_step;
  options.keep_virtual = true;
  options.finder.from_simulation = options.finder.from_random = false;
  return trace_orbits(family, options);
}

std::vector<double> folds_of(const OrbitBranches& result) {
  std::vector<double> folds;
  for (const OrbitBranch& branch : result.branches)
    for (const SpecialPoint& special : branch.special)
      if (special.kind == SpecialKind::kFold) folds.push_back(special.at.value);
  std::sort(folds.begin(), folds.end());
  return folds;
}

Scene paper_beam() {
  return read_scene(GRAZE_SOURCE_DIR "/data/scenes/05_wagg_one_mode.toml",
                    {"beam.modes=4", "stop.gap=5e-3"});
}

TEST(NarrowComponents, AllFoldsAreFoundOnceWhateverTheStep) {
  for (const double max_step : {0.0, 0.005, 0.05, 2.0, 20.0}) {
    const OrbitBranches result = traced(paper_beam(), 20.0, 40.0, max_step);
    const std::vector<double> folds = folds_of(result);
    ASSERT_EQ(folds.size(), 34u) << max_step;
    EXPECT_NEAR(folds.front(), 22.231388, 1e-6);
    for (std::size_t i = 1; i < folds.size(); ++i) EXPECT_GT(folds[i] - folds[i - 1], 1e-6);
    EXPECT_EQ(result.sought.ranges, 17);
    EXPECT_TRUE(result.sought.complete());
  }
}

TEST(NarrowComponents, NothingIsTracedAcrossTheGapWithoutSolutions) {
  for (const OrbitBranch& branch : traced(paper_beam(), 20.0, 40.0, 2.0).branches)
    for (const OrbitBranchPoint& point : branch.points)
      EXPECT_FALSE(point.value > 30.835599 + 1e-6 && point.value < 30.854859 - 1e-6);
}

using support::Real;

// An oscillator of unit mass and frequency under a unit force.
struct Oscillator {
  Real ratio, restitution, gap;

  // |kappa| - gap
  Real excess(Real frequency) const {
    return std::abs(support::impact_response(ratio, restitution, frequency).kappa) - gap;
  }

  std::vector<double> folds(Real from, Real to, int samples) const {
    std::vector<double> list;
    Real before = excess(from);
    for (int i = 1; i <= samples; ++i) {
      Real low = from + (to - from) * (i - 1) / samples, high = from + (to - from) * i / samples;
      const Real here = excess(high);
      if ((before > 0) != (here > 0)) {
        for (int halving = 0; halving < 60; ++halving) {
          const Real middle = (low + high) / 2;
          ((excess(middle) > 0) == (before > 0) ? low : high) = middle;
        }
        list.push_back(static_cast<double>(low));
      }
      before = here;
    }
    return list;
  }
};

// Seven components over [0.2, 0.7] at frequencies 1/m, m = 2..5, the narrowest 7e-5 wide, and gaps
// of 3e-5 between some of them: a sample every 1.2e-4 saw three.
TEST(NarrowComponents, OfAnOscillatorHardlyDampedAreAllFoundWhateverTheStep) {
  const Scene scene =
      read_scene(GRAZE_SOURCE_DIR "/data/scenes/04_impact_oscillator.toml",
                 {"modal.damping_ratios=[1e-7]", "stop.gap=200.0", "forcing.frequency=0.6"});
  const std::vector<double> expected = Oscillator{1e-7L, 0.8L, 200}.folds(0.2L, 0.7L, 1'000'000);
  ASSERT_EQ(expected.size(), 14u);
  for (const double max_step : {0.0, 1e-4, 1e-2, 0.5}) {
    const OrbitBranches result = traced(scene, 0.2, 0.7, max_step);
    const std::vector<double> folds = folds_of(result);
    ASSERT_EQ(folds.size(), expected.size()) << max_step;
    for (std::size_t i = 0; i < folds.size(); ++i)
      EXPECT_NEAR(folds[i], expected[i], 1e-10) << max_step;
    EXPECT_EQ(result.branches.size(), 7u);
    for (const OrbitBranch& branch : result.branches)
      EXPECT_EQ(branch.ends[0], OrbitBranchEnd::kClosed) << branch.id;
    EXPECT_TRUE(result.sought.complete());
  }
}

}  // namespace
}  // namespace graze
