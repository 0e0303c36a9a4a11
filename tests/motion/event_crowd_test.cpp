// Runs that spend their budget where events crowd together say which stops do what.
#include "graze/motion/detail/event_crowd.hpp"

#include <gtest/gtest.h>

#include <string>

#include "graze/motion/simulation.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

Event event_of(EventKind kind, int stop, double time, double speed) {
  Event event;
  event.kind = kind;
  event.stop = stop;
  event.time = time;
  event.speed = speed;
  return event;
}

// Three events in turn, 1 us apart.
EventCrowd crowd_of(int events) {
  EventCrowd crowd;
  for (int i = 0; i < events; ++i) {
    const EventKind kind = i % 3 == 2 ? EventKind::kRelease : EventKind::kImpact;
    crowd.add(
        event_of(kind, i % 3 == 1 ? 4 : 1, 1.0 + 1e-6 * i, i % 3 == 1 ? 2e-7 : 1e-9 * (i + 1)));
  }
  return crowd;
}

TEST(EventCrowd, SaysWhichStopsDoWhat) {
  // The last 512 of 600: of each kind 171, 170, 171.
  EXPECT_EQ(crowd_of(600).sentence(1.0, Units::kSi),
            "; the last 512 events took 0.00051 s: stop 2, 170 impacts at 9.1e-08 to 6.0e-07 m/s, "
            "171 releases; stop 5, 171 impacts at 2.0e-07 to 2.0e-07 m/s");
  EXPECT_EQ(crowd_of(600).sentence(1.0, Units::kNone),
            "; the last 512 events took 0.00051: stop 2, 170 impacts at 9.1e-08 to 6.0e-07, "
            "171 releases; stop 5, 171 impacts at 2.0e-07 to 2.0e-07");
}

TEST(EventCrowd, IsSilentWhereEventsAreTheMotion) {
  EXPECT_EQ(crowd_of(511).sentence(1.0, Units::kSi), "");   // too few
  EXPECT_EQ(crowd_of(600).sentence(5e-3, Units::kSi), "");  // a tenth of a period
  EXPECT_NE(crowd_of(600).sentence(6e-3, Units::kSi), "");
}

// Pressed onto the stop, a chatter that is not summed: its
// impacts crowd together until the budget ends the run.
TEST(EventCrowd, StandsInTheSentenceOfARunOutOfItsBudget) {
  System system = support::forced_oscillator(1.0, 0.05, 0.1, 0.8, 1.6, 1.0);
  SimulationOptions options = support::for_periods(1000);
  options.max_impacts = 5;
  EXPECT_EQ(simulate(system, support::rest(system), options).crowd.find("events took"),
            std::string::npos);
  system.modal().load = Vector::Constant(1, 100.0);  // presses it onto the stop
  system.stops.front().impact().restitution = Restitution{0.99};
  options.closure_speed = 1e-300;
  options.max_impacts = 2500;
  const Simulation run = simulate(system, support::rest(system), options);
  ASSERT_EQ(run.outcome, RunOutcome::kEventBudget);
  EXPECT_NE(run.crowd.find("the last 512 events took"), std::string::npos) << run.crowd;
  EXPECT_NE(run.crowd.find("stop 1, 512 impacts at"), std::string::npos) << run.crowd;
}

}  // namespace
}  // namespace graze
