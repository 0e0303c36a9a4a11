// Starts at random press no spring deeper than motions at their speed can.
#include "graze/orbit/search/detail/random_start.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "graze/assembly/assembly.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

constexpr int kDraws = 200;

std::string scene_file(const std::string& name) {
  return std::string(GRAZE_SOURCE_DIR) + "/data/scenes/" + name;
}

double depth_at(const Stop& stop, const State& state) { return stop.row.dot(state.q) - stop.gap; }

// Before, a start a millimetre within the steel ball held 100 J, and its motions took minutes.
TEST(RandomStart, HoldsNoMoreEnergyInASpringThanTheFastestImpactBrings) {
  const System system = assemble(read_scene(scene_file("14_beam_against_a_ball.toml")));
  const Stop& stop = system.stops[0];
  const double speed = 2.0 * motion_scale(system).speed;
  const double energy = 0.5 * speed * speed / stop.row.squaredNorm();
  double deepest = 0.0;
  for (std::uint64_t draw = 0; draw < kDraws; ++draw)
    deepest = std::max(deepest, depth_at(stop, random_start(system, 1, draw)));
  ASSERT_GT(deepest, 0.0);
  EXPECT_LE(stop.force().stored(deepest), energy * (1.0 + 1e-9));
  EXPECT_GE(stop.force().stored(deepest), energy * (1.0 - 1e-9));
}

// A spring as soft as the structure is pressed as deep as motions reach anyway.
TEST(RandomStart, IsFreeOnASoftSpring) {
  const Scene scene = parse_scene(R"(
[modal]
frequencies = [1.0]
participation = [1.0]
[forcing]
kind = "modal"
amplitude = 1.0
frequency = 2.0
[[stop]]
shape = [1.0]
gap = 0.0
[stop.spring]
stiffness = 0.5
exponent = 1.0
)",
                                  "soft");
  const System system = assemble(scene);
  double deepest = 0.0;
  for (std::uint64_t draw = 0; draw < kDraws; ++draw)
    deepest = std::max(deepest, depth_at(system.stops[0], random_start(system, 1, draw)));
  // Twice the scale, 1/4, beyond the steady response, 1/(1 - 4) at phase 0.
  EXPECT_NEAR(deepest, 2.0 / 4.0 - 1.0 / 3.0, 0.01);
}

}  // namespace
}  // namespace graze
