// An orbit once a forcing period: what a simulation of it shows there.
#include "graze/study/sweep/detail/stroboscopic_states.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"

#include <gtest/gtest.h>

#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/scene/reader.hpp"
#include "graze/study/sweep/sweep.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// Orbits of (1, 1), (2, 1) and (2, 2); and with a phase of the forcing, which moves the instants.
TEST(StroboscopicStates, AreWhatTheSettledMotionShows) {
  for (const char* settings : {"forcing.frequency=1.6", "forcing.frequency=4.0",
                               "forcing.frequency=2.7", "forcing.phase=2.5"}) {
    SCOPED_TRACE(settings);
    const Scene scene = read_scene(GRAZE_SOURCE_DIR "/data/scenes/04_impact_oscillator.toml",
                                   {"forcing.frequency=1.6", settings});
    const System system = assemble(scene);
    SettleOptions options;
    options.nearness = 1e-11;
    const SettledMotion settled = settle(system, initial_state(scene, system), options);
    ASSERT_EQ(settled.kind, SettledKind::kImpacts) << settled.classification;
    const ShootingProblem problem(*settled.pattern, motion_scale(system));
    const Orbit orbit = make_orbit(system, problem, problem.pack(system, settled.points));
    const std::vector<State> states = stroboscopic_states(system, orbit);
    ASSERT_EQ(states.size(), settled.period_states.size());
    // The orbit may be listed from another of its periods on.
    double least = 1.0;
    for (std::size_t turn = 0; turn < states.size(); ++turn) {
      double farthest = 0.0;
      for (std::size_t i = 0; i < states.size(); ++i) {
        const State &a = states[i], &b = settled.period_states[(i + turn) % states.size()];
        farthest = std::max({farthest, (a.q - b.q).norm(), (a.qdot - b.qdot).norm()});
      }
      least = std::min(least, farthest);
    }
    EXPECT_LE(least, 1e-10);
  }
}

}  // namespace
}  // namespace graze
