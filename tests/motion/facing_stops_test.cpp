// Two stops that face each other at one place hold it still, whichever of them is pressed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/scene/reader.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

support::RecordedRun run_of(const std::string& text, double seconds) {
  const Scene scene = parse_scene(text, "scene");
  const System system = assemble(scene);
  SimulationOptions options = support::for_seconds(seconds);
  options.energy = true;
  return support::record_run(system, initial_state(scene, system), options);
}

std::vector<double> impacts_of(const support::RecordedRun& run) {
  std::vector<double> times;
  for (const Event& event : run.events)
    if (event.kind == EventKind::kImpact) times.push_back(event.time);
  return times;
}

// A mass that is pinned between two stops is a wall for the one that hangs on it: its force changes
// from one stop to the other as that swings, in flight and where a chatter comes to rest.
TEST(FacingStops, AreAWall) {
  const std::string stop = "[[stop]]\nmass = 1\ngap = 0.0\nside = \"below\"\nrestitution = 0.6\n";
  const auto forced = [](double amplitude) {
    return fmt::format("[forcing]\nmass = 1\namplitude = {}\nfrequency = 1.7\n", amplitude);
  };
  const std::string walled =
      "[lumped]\nmasses = [1]\n[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 6\ndamping = 0.1\n"
      "[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 3\n";
  const std::string pinned =
      "[lumped]\nmasses = [1, 2]\n[[lumped.spring]]\nbetween = [1, 2]\nstiffness = 6\n"
      "damping = 0.1\n[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 3\n";
  const std::string both =
      "[[stop]]\nmass = 2\ngap = 0.0\nside = \"below\"\nrestitution = 0.99\n"
      "[[stop]]\nmass = 2\ngap = 0.0\nrestitution = 0.2\n";
  for (const double amplitude : {2.0, -3.0}) {
    const auto wall = run_of(walled + forced(amplitude) + stop, 40.0);
    for (const std::string& stops : {both + stop, stop + both}) {
      const auto run = run_of(pinned + forced(amplitude) + stops, 40.0);
      ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
      EXPECT_LE(std::abs(run.result.energy->defect()), 1e-12 * run.result.energy->size());
      const std::vector<double> expected = impacts_of(wall), found = impacts_of(run);
      // Of a chatter more or fewer impacts are resolved, at the instant at which it ends.
      for (const double time : {5.0, 15.0, 25.0, 39.0}) {
        const auto next = [&](const std::vector<double>& list) {
          return *std::lower_bound(list.begin(), list.end(), time);
        };
        EXPECT_NEAR(next(found), next(expected), 1e-10);
      }
    }
  }
}

}  // namespace
}  // namespace graze
