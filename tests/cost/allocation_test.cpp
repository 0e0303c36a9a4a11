// Once a run has begun no arc asks for memory: twice as many forcing periods, as many allocations.
#include <gtest/gtest.h>

#include "counted_allocations.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "noted_cost.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

long long allocations_of(const std::function<void()>& work) {
  const long long before = cost::allocations();
  work();
  return cost::allocations() - before;
}

struct Case {
  const char* name;
  const char* scene;
  std::vector<std::string> settings;
  bool energy = false;
  double samples = 0.0;  // 1/s
};

void expect_none_by_arcs(const Case& c) {
  SCOPED_TRACE(c.name);
  const Scene scene = support::shipped_scene(c.scene, c.settings);
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  long long events = 0;
  double sum = 0.0;
  RunListeners listeners;
  listeners.event = [&](const Event&) { ++events; };
  if (c.samples > 0.0) {
    listeners.sample = [&](const Sample& sample) { sum += sample.state.q[0]; };
    listeners.sample_rate = c.samples;
  }
  SimulationOptions options;
  options.energy = c.energy;
  const auto run = [&](long long periods) {
    options.periods = periods;
    return allocations_of([&] { simulate(system, start, options, listeners); });
  };
  const long long first = run(60), early = events;
  EXPECT_EQ(run(120), first);
  EXPECT_GT(events - early, early + 20);  // the longer run has more to do
}

TEST(Allocation, IsCounted) {
  EXPECT_EQ(allocations_of([] { EXPECT_EQ(Vector(Vector::Zero(5)).size(), 5); }), 1);
  EXPECT_EQ(allocations_of([] { EXPECT_EQ(std::vector<double>(5, 1.0).size(), 5u); }), 1);
}

// A stop that closes or opens makes its contact phase once, and shares the push among stops.
TEST(Allocation, NoneByArcs) {
  for (const Case& c :
       {Case{"impacts of four modes", "02_wagg_momentum", {"stop.gap=7e-3"}},
        Case{"collocation", "01_wagg_2004", {"stop.gap=5e-3"}},
        Case{"samples", "02_wagg_momentum", {"stop.gap=7e-3"}, false, 1000.0},
        Case{"two stops", "07_two_stops", {"stop.1.restitution=0.95", "stop.2.restitution=0.95"}},
        Case{"one mode", "05_wagg_one_mode", {}}})
    expect_none_by_arcs(c);
}

}  // namespace
}  // namespace graze
