// States that motions of a place start from, and when an unsettled one is followed on.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/orbit/search/detail/random_start.hpp"
#include "graze/scene/reader.hpp"
#include "graze/study/sweep/detail/followed_motion.hpp"

namespace graze {
namespace {

System system_of(const std::string& name, const std::vector<std::string>& settings = {}) {
  return assemble(read_scene(GRAZE_SOURCE_DIR "/data/scenes/" + name + ".toml", settings));
}

double penetration(const Stop& stop, const State& state) {
  return stop.row.dot(state.q) - stop.gap;
}

TEST(BringClear, PutsBackOntoTheStopAlongItsImpulse) {
  const System system = system_of("02_wagg_momentum");
  const Stop& stop = system.stops[0];
  State state{Vector::Constant(system.modes(), 1e-4), Vector::Constant(system.modes(), 0.01)};
  state.q += stop.direction() * (1e-3 - penetration(stop, state));  // 1 mm too far
  const State before = state;
  EXPECT_FALSE(is_clear(system, state));
  EXPECT_TRUE(bring_clear(system, state));
  EXPECT_NEAR(penetration(stop, state), 0.0, 1e-15);
  EXPECT_NEAR((state.q - before.q + 1e-3 * stop.direction()).norm(), 0.0, 1e-15);
  EXPECT_EQ(state.qdot, before.qdot);
}

TEST(BringClear, LeavesWhatIsClear) {
  const System system = system_of("07_two_stops");
  State state{Vector::Zero(system.modes()), Vector::Ones(system.modes())};
  EXPECT_TRUE(bring_clear(system, state));
  EXPECT_EQ(state.q, Vector::Zero(system.modes()));
}

TEST(RandomStart, IsClearAndTheSameForTheSameNumbers) {
  for (const char* scene : {"02_wagg_momentum", "07_two_stops", "08_preloaded_oscillator"}) {
    const System system = system_of(scene);
    for (std::uint64_t draw = 0; draw < 50; ++draw) {
      const State state = random_start(system, 1, draw);
      EXPECT_TRUE(is_clear(system, state)) << scene << draw;
      EXPECT_EQ(state.q, random_start(system, 1, draw).q);
      EXPECT_NE(state.qdot, random_start(system, 2, draw).qdot);
      EXPECT_NE(state.qdot, random_start(system, 1, draw + 1).qdot);
    }
  }
}

SettledMotion seen(int count, double (*displacement)(int)) {
  SettledMotion motion;
  for (int i = 0; i < count; ++i)
    motion.period_states.push_back({Vector::Constant(1, displacement(i)), Vector::Zero(1)});
  return motion;
}

TEST(IsNearing, FromStatesAtPeriods) {
  const System system = system_of("05_wagg_one_mode");
  EXPECT_TRUE(is_nearing(system, seen(100, [](int i) { return 1e-4 * std::pow(0.999, i); }), 1));
  const auto doubled = [](int i) { return (i % 2 == 0 ? 1e-3 : -1e-3) + 1e-4 * std::pow(0.99, i); };
  EXPECT_TRUE(is_nearing(system, seen(100, doubled), 2));
  EXPECT_FALSE(is_nearing(system, seen(100, [](int i) { return 1e-4 * std::pow(1.001, i); }), 2));
  EXPECT_FALSE(is_nearing(system, seen(100, [](int) { return 1e-3; }), 2));
  EXPECT_FALSE(is_nearing(system, seen(100, [](int i) { return std::sin(1.0 * i * i); }), 2));
  EXPECT_FALSE(is_nearing(system, seen(3, [](int i) { return std::pow(0.5, i); }), 2));
}

}  // namespace
}  // namespace graze
