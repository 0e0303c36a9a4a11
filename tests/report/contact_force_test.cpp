// The contact force of a picture reaches what the events tell, however far apart the samples are.
#include <gtest/gtest.h>

#include <algorithm>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/report/chart/detail/motion_seen.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

TEST(ContactForce, ReachesTheLargestOfEveryContact) {
  const Scene scene = support::shipped_scene("13_beam_on_a_spring");
  for (const double rate : {100.0, 1e4, 1e6}) {
    SimulationRecord record;
    record.system = assemble(scene);
    SimulationOptions options;
    options.duration = 0.3;
    RunListeners listeners;
    listeners.event = [&](const Event& event) { record.events.push_back(event); };
    listeners.sample = [&](const Sample& sample) { record.samples.push_back(sample); };
    listeners.sample_rate = rate;
    record.run = simulate(record.system, initial_state(scene, record.system), options, listeners);
    const MotionSeen seen = motion_seen(record);
    ASSERT_EQ(seen.forces.size(), 1u);
    const DrawnCurve& force = seen.forces[0].force;
    int contacts = 0;
    for (const Event& event : record.events) {
      if (event.kind != EventKind::kSeparation) continue;
      ++contacts;
      double most = 0.0;
      for (const DrawnPoint& point : force)
        if (point.time >= event.time - event.duration && point.time <= event.time)
          most = std::max(most, point.value);
      EXPECT_NEAR(most, event.peak_force, 1e-9 * event.peak_force) << rate << " " << event.time;
    }
    EXPECT_GT(contacts, 2);
    EXPECT_TRUE(std::is_sorted(force.begin(), force.end(),
                               [](const auto& a, const auto& b) { return a.time < b.time; }));
  }
}

}  // namespace
}  // namespace graze
