// Bars that meet a wall with the spring of the modes left out: what waves make of it, and published
// numbers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/scene/reader.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

support::RecordedRun run_of(const Scene& scene, double seconds) {
  const System system = assemble(scene);
  return support::record_run(system, initial_state(scene, system), support::for_seconds(seconds));
}

std::vector<double> times_of(const std::vector<Event>& events, EventKind kind) {
  std::vector<double> times;
  for (const Event& event : events)
    if (event.kind == kind) times.push_back(event.time);
  return times;
}

// First of the rising times from `from` on, and last until then.
double first_from(const std::vector<double>& times, double from) {
  return *std::lower_bound(times.begin(), times.end(), from);
}
double last_until(const std::vector<double>& times, double until) {
  return *(std::upper_bound(times.begin(), times.end(), until) - 1);
}

// An elastic bar, length 10, wave speed 30, falls by 5 under a gravity of 10 and is dropped again
// by itself for ever: contacts from 1 to 5/3 and from 11/3 to 13/3, then all over again after 16/3.
//   D. Doyen, A. Ern, S. Piperno, SIAM J. Sci. Comput. 33 (2011) 223-249.
TEST(ResidualSpringMotion, OfADroppedBarRepeatsItself) {
  for (const int modes : {32, 64, 128, 256}) {
    const auto run =
        run_of(support::shipped_scene("26_dropped_bar", {fmt::format("bar.modes={}", modes)}), 7.5);
    ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
    const std::vector<double> contacts = times_of(run.events, EventKind::kContact);
    const std::vector<double> separations = times_of(run.events, EventKind::kSeparation);
    // Of the first order in 1/N; 1e-2 at 128.
    const double allowed = 1.28 / modes;
    EXPECT_NEAR(contacts.front(), 1.0, 1e-12) << modes;
    EXPECT_NEAR(last_until(separations, 2.5), 5.0 / 3.0, allowed) << modes;
    EXPECT_NEAR(first_from(contacts, 2.5), 11.0 / 3.0, allowed) << modes;
    EXPECT_NEAR(last_until(separations, 5.5), 13.0 / 3.0, allowed) << modes;
    EXPECT_NEAR(first_from(contacts, 5.5), 1.0 + 16.0 / 3.0, allowed) << modes;
    EXPECT_NEAR(last_until(separations, 7.5), 5.0 / 3.0 + 16.0 / 3.0, allowed) << modes;
  }
}

// A bar of length 1 and wave speed 1 flies at a wall: exactly, it is thrown back as fast as it came
// after 2. Mean force, its change of momentum over the duration.
TEST(ResidualSpringMotion, OfABarAgainstAWall) {
  struct Row {
    int modes;
    double rebound, duration;
  };
  for (const Row& row : {Row{17, 0.9938, 1.981}, {65, 0.9992, 2.0015}, {128, 0.9979, 1.9963}}) {
    std::string speeds = "-1.0";
    for (int j = 1; j < row.modes; ++j) speeds += ", 0.0";
    const auto run = run_of(
        parse_scene(fmt::format("[bar]\nlength = 1.0\nyoungs_modulus = 1.0\ndensity = 1.0\n"
                                "area = 1.0\nends = [\"free\", \"free\"]\nmodes = {}\n[[stop]]\n"
                                "position = 0.0\ngap = 0.1\nside = \"below\"\n[stop.spring]\n"
                                "stiffness = \"residual\"\n[initial]\nqdot = [{}]\n",
                                row.modes, speeds),
                    "test.toml"),
        3.0);
    const std::vector<double> separations = times_of(run.events, EventKind::kSeparation);
    EXPECT_NEAR(run.result.final.qdot[0], row.rebound, 0.5e-4) << row.modes;
    EXPECT_NEAR(separations.back() - 0.1, row.duration, row.modes == 17 ? 0.5e-3 : 0.5e-4)
        << row.modes;
  }
}

}  // namespace
}  // namespace graze
