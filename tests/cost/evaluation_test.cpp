// What a scene does not name, or names and leaves without effect, changes no evaluation and no bit.
#include <gtest/gtest.h>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/scene/reader.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

struct Followed {
  long long evaluations = 0;
  std::vector<double> events;  // times and speeds
  Vector end;
};

Followed follow(const Scene& scene, bool energy = false, double samples = 0.0) {
  const System system = assemble(scene);
  SimulationOptions options;
  options.periods = 50;
  options.energy = energy;
  Followed followed;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    followed.events.push_back(event.time);
    followed.events.push_back(event.speed);
  };
  if (samples > 0.0) {
    listeners.sample = [](const Sample&) {};
    listeners.sample_rate = samples;
  }
  const Simulation run = simulate(system, initial_state(scene, system), options, listeners);
  followed.evaluations = run.evaluations;
  followed.end = run.final.q;
  return followed;
}

void expect_same(const Followed& a, const Followed& b, const std::string& what) {
  SCOPED_TRACE(what);
  EXPECT_EQ(a.evaluations, b.evaluations);
  EXPECT_EQ(a.events, b.events);
  EXPECT_EQ(a.end, b.end);
}

Scene beam(const std::vector<std::string>& settings = {}) {
  std::vector<std::string> all = {"stop.gap=5e-3"};
  all.insert(all.end(), settings.begin(), settings.end());
  return support::shipped_scene("02_wagg_momentum", all);
}

TEST(Evaluations, AreThoseOfTheBaselineWithoutAnEffect) {
  const Followed baseline = follow(beam());
  ASSERT_GT(baseline.events.size(), 100u);
  expect_same(baseline, follow(beam({"stop.restitution=[0.8, 0, 0]"})), "r(v) that is constant");
  Scene still = beam();
  still.gravity = Gravity{0.0};
  expect_same(baseline, follow(still), "gravity of no size");
  Scene undamped = beam();
  undamped.damping.reset();
  Scene of_no_ratio = undamped, of_no_rayleigh = undamped;
  of_no_ratio.damping = DampingRatios{{0.0, 0.0, 0.0, 0.0}};
  of_no_rayleigh.damping = RayleighDamping{0.0, 0.0};
  const Followed free = follow(undamped);
  expect_same(free, follow(of_no_ratio), "damping ratios of zero");
  expect_same(free, follow(of_no_rayleigh), "Rayleigh damping of zero");
}

TEST(Evaluations, AreNotMoreForWhoListens) {
  const Followed baseline = follow(beam());
  expect_same(baseline, follow(beam(), true), "the energy balance");
  expect_same(baseline, follow(beam(), false, 500.0), "samples");
}

TEST(Evaluations, NoneWithoutAStop) {
  Scene scene = beam();
  scene.stops.clear();
  const Followed followed = follow(scene, true, 500.0);
  EXPECT_EQ(followed.evaluations, 0);
  EXPECT_TRUE(followed.events.empty());
}

}  // namespace
}  // namespace graze
