// A closed form's two solutions are two families over the parameter; at a sharp swing a step can
// cross from one to the other unless something tells them apart.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// Folds in the range: where |kappa| crosses the gap, on a grid 25 times finer than the swings.
int folds_of_closed_form(const SystemFamily& family, int period, double from, double to) {
  constexpr int kSamples = 60000;
  int folds = 0;
  bool before = false;
  for (int i = 0; i <= kSamples; ++i) {
    const System system = *family.at(from + (to - from) * i / kSamples);
    const ClosedFormAnswer answer = closed_form(system, 0, period);
    const bool exists = std::abs(answer.form->kappa) >= std::abs(system.stops[0].gap);
    if (i > 0 && exists != before) ++folds;
    before = exists;
  }
  return folds;
}

void expect_every_fold_once(const std::vector<std::string>& settings, int period, double from,
                            double to) {
  const Scene scene = read_scene(GRAZE_SOURCE_DIR "/data/scenes/05_wagg_one_mode.toml", settings);
  const SystemFamily family(scene, "forcing.frequency");
  BranchOptions options;
  options.period = period;
  options.from = from;
  options.to = to;
  options.keep_virtual = true;
  options.finder.from_simulation = options.finder.from_random = false;
  const OrbitBranches traced = trace_orbits(family, options);
  int folds = 0;
  for (const OrbitBranch& branch : traced.branches)
    for (const SpecialPoint& special : branch.special)
      folds += special.kind == SpecialKind::kFold ? 1 : 0;
  EXPECT_EQ(folds, folds_of_closed_form(family, period, from, to));
  EXPECT_EQ(traced.cut_short, 0);
}

TEST(Families, OrbitsOfThreePeriodsKeepTheirFamily) { expect_every_fold_once({}, 3, 15.0, 120.0); }

TEST(Families, OrbitsOfFourPeriodsKeepTheirFamily) {
  expect_every_fold_once({"stop.gap=0.0010117887206914083", "stop.restitution=0.95"}, 4,
                         20.491707574287496, 112.1432344695786);
}

}  // namespace
}  // namespace graze
