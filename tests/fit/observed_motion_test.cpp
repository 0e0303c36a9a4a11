// What is observed of a motion is what `simulate` says of it.
#include "graze/fit/detail/observed_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

const std::string kScenes = std::string(GRAZE_SOURCE_DIR) + "/data/scenes/";

struct Seen {
  std::vector<Sample> samples;
  std::vector<Event> impacts;
};

Seen simulated(const System& system, const State& start, double duration, double rate) {
  Seen seen;
  SimulationOptions options;
  options.duration = duration;
  RunListeners listeners;
  listeners.sample = [&](const Sample& sample) { seen.samples.push_back(sample); };
  listeners.sample_rate = rate;
  listeners.event = [&](const Event& event) {
    if (event.kind == EventKind::kImpact || event.kind == EventKind::kContact)
      seen.impacts.push_back(event);
  };
  simulate(system, start, options, listeners);
  return seen;
}

void expect_the_same(const Scene& scene, double duration, double rate, std::size_t impacts) {
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  const Seen seen = simulated(system, start, duration, rate);
  ASSERT_GE(seen.impacts.size(), impacts);
  Observation observation;
  observation.end = duration;
  observation.forces = true;
  observation.closure_speed = default_closure_speed(system, start);
  observation.max_impacts = kDefaultImpactBudget;
  for (const Sample& sample : seen.samples) observation.times.push_back(sample.time);
  std::size_t handed = 0, met = 0;
  double q_size = 0.0, force_size = 1.0;
  for (const Sample& sample : seen.samples) {
    q_size = std::max(q_size, sample.state.q.cwiseAbs().maxCoeff());
    for (const double force : sample.forces) force_size = std::max(force_size, force);
  }
  observation.state = [&](const Observed& observed) {
    const Sample& sample = seen.samples[observed.index];
    EXPECT_EQ(observed.index, handed++);
    EXPECT_LT((observed.q - sample.state.q).cwiseAbs().maxCoeff(), 1e-12 * q_size) << sample.time;
    for (std::size_t i = 0; i < sample.forces.size(); ++i)
      EXPECT_NEAR(observed.forces[static_cast<Eigen::Index>(i)], sample.forces[i],
                  1e-9 * force_size)
          << sample.time;
  };
  observation.impact = [&](int stop, double time) {
    EXPECT_EQ(stop, seen.impacts[met].stop);
    EXPECT_EQ(time, seen.impacts[met].time);
    ++met;
    return true;
  };
  EXPECT_EQ(observe(system, start, observation), "");
  EXPECT_EQ(handed, seen.samples.size());
  EXPECT_EQ(met, seen.impacts.size());
}

TEST(ObservedMotion, IsThatOfASimulation) {
  // Impacts, chatter, sticking and release; with and without forcing; two stops.
  expect_the_same(read_scene(kScenes + "09_soft_stop_two_modes.toml"), 2.0, 333.0, 20);
  expect_the_same(read_scene(kScenes + "06_bouncing_ball.toml"), 5.0, 10.0, 20);
  expect_the_same(read_scene(kScenes + "07_two_stops.toml"), 30.0, 10.0, 5);
  expect_the_same(read_scene(kScenes + "08_preloaded_oscillator.toml"), 40.0, 7.0, 5);
}

TEST(ObservedMotion, GoesThroughCompliantStops) {
  expect_the_same(parse_scene("[modal]\nfrequencies = [3.0]\n[[stop]]\nshape = [1.0]\ngap = 0.1\n"
                              "[stop.spring]\nstiffness = 1e6\nexponent = 1.5\n[initial]\nqdot = "
                              "[0.5]\n",
                              "spring"),
                  5.0, 2000.0, 2);
}

TEST(ObservedMotion, EndsWhereItIsTold) {
  const Scene scene = read_scene(kScenes + "06_bouncing_ball.toml");
  const System system = assemble(scene);
  Observation observation;
  observation.end = 5.0;
  observation.max_impacts = 100;
  int met = 0;
  observation.impact = [&](int, double) { return ++met < 3; };
  EXPECT_EQ(observe(system, initial_state(scene, system), observation), "");
  EXPECT_EQ(met, 3);
  observation.max_impacts = 2;
  met = -100;
  // The second flight ends after sqrt(2/9.81) (1 + 2 * 0.8 + 2 * 0.64) s.
  EXPECT_EQ(observe(system, initial_state(scene, system), observation),
            "at t = 1.75191173 s the budget of 2 impacts was spent");
}

}  // namespace
}  // namespace graze
