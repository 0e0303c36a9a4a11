// How the stable period-1 impact is lost with the number of modes. The counts are those of an
// independent closed-form computation: of 2200 forcing frequencies from 10 rad/s in steps of
// 0.05 rad/s, at gap 1.05 mm under the momentum law, this many have a stable admissible (1,1)
// orbit.
#include <gtest/gtest.h>

#include "graze/assembly/assembly.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/orbit/problem/orbit.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

bool has_stable_orbit(const System& system) {
  const ClosedFormAnswer answer = closed_form(system, 0, 1);
  if (!answer.form) return false;
  const ShootingProblem problem({1, {0}}, motion_scale(system));
  for (const ImpactPoint& point : answer.form->solutions(system.stops[0].gap)) {
    const Orbit orbit = make_orbit(system, problem, problem.pack(system, {point}));
    if (orbit.admissible && orbit.stable.value_or(false)) return true;
  }
  return false;
}

class PeriodOneCount : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(PeriodOneCount, MatchesIndependentComputation) {
  const auto [modes, expected] = GetParam();
  const Scene scene = read_scene(GRAZE_SOURCE_DIR "/data/scenes/05_wagg_one_mode.toml",
                                 {"beam.modes=" + std::to_string(modes)});
  int count = 0;
  for (int i = 0; i < 2200; ++i)
    count += has_stable_orbit(assemble(with_parameter(scene, "forcing.frequency", 10 + 0.05 * i)));
  EXPECT_EQ(count, expected);
}

INSTANTIATE_TEST_SUITE_P(PaperBeam, PeriodOneCount,
                         testing::Values(std::pair{1, 784}, std::pair{2, 154}, std::pair{3, 33},
                                         std::pair{4, 5}, std::pair{8, 0}));

}  // namespace
}  // namespace graze
