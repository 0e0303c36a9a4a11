// Runs of orbits among the (1, 1) solutions: none is missed. The referee judges the closed form at
// many more values than were ever sampled.
#include "graze/bifurcation/bounds/detail/admissible_runs.hpp"

#include <gtest/gtest.h>

#include "branch_checks.hpp"

namespace graze {
namespace {

// Orbits of the closed form at a value, by their speeds.
std::vector<double> orbit_speeds(const SystemFamily& family, double value) {
  const System system = *family.at(value);
  const ClosedFormAnswer answer = closed_form(system, 0, 1);
  std::vector<double> speeds;
  if (!answer.form) return speeds;
  for (const ImpactPoint& point : answer.form->solutions(system.stops[0].gap))
    if (admissibility(system, {1, {0}}, {point}).admissible)
      speeds.push_back(system.stops[0].row.dot(point.before.qdot));
  return speeds;
}

void expect_all_runs(const SystemFamily& family, double from, double to, double max_step,
                     int samples) {
  BranchOptions options;
  options.from = from;
  options.to = to;
  options.max_step = max_step;
  options.sticking = false;
  options.finder.from_simulation = options.finder.from_random = false;
  const OrbitBranches result = trace_orbits(family, options);
  EXPECT_TRUE(result.sought.complete());
  EXPECT_GT(result.sought.cells, 0);
  int seen = 0;
  for (int i = 1; i < samples; ++i) {
    const double value = from + (to - from) * i / samples;
    const auto speeds = orbit_speeds(family, value);
    if (speeds.empty()) continue;
    seen += static_cast<int>(speeds.size());
    EXPECT_EQ(support::segments(result, value), static_cast<int>(speeds.size())) << value;
  }
  EXPECT_GT(seen, 0);
}

TEST(AdmissibleRuns, OfFourModesAreAllTracedWhateverTheStep) {
  const SystemFamily family(support::shipped_scene("05_wagg_one_mode", {"beam.modes=4"}),
                            "forcing.frequency");
  for (const double max_step : {0.0, 0.05, 40.0})
    expect_all_runs(family, 20.0, 60.0, max_step, 10'007);
}

// Undamped, where every cell with a subharmonic of the mode holds a pole.
TEST(AdmissibleRuns, OfAnUndampedOscillatorAreAllTraced) {
  const SystemFamily family(support::shipped_scene("04_impact_oscillator",
                                                   {"modal.damping_ratios=[0.0]", "stop.gap=0.4"}),
                            "forcing.frequency");
  expect_all_runs(family, 0.3, 4.0, 0.0, 5'003);
}

TEST(AdmissibleRuns, OverOtherParametersAreAllTraced) {
  const Scene scene =
      support::shipped_scene("05_wagg_one_mode", {"beam.modes=3", "forcing.frequency=25.3"});
  expect_all_runs({scene, "stop.gap"}, 1e-4, 1e-2, 0.0, 5'003);
  expect_all_runs({scene, "stop.restitution"}, 0.05, 0.99, 0.0, 5'003);
  expect_all_runs({scene, "beam.density"}, 6000.0, 12000.0, 0.0, 5'003);
}

}  // namespace
}  // namespace graze
