// Impact times and speeds against tests/reference/impact_times.csv (50 digits, independent) and
// against the digits printed with the two shipped scenes' issue.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::for_seconds;
using support::RecordedRun;

std::map<std::string, std::vector<support::TableRow>> rows_by_case() {
  std::map<std::string, std::vector<support::TableRow>> cases;
  for (const support::TableRow& row : support::read_table("impact_times.csv"))
    cases[row.at("case")].push_back(row);
  return cases;
}

RecordedRun run_scene(const Scene& scene, double seconds) {
  const System system = assemble(scene);
  return support::record_run(system, initial_state(scene, system), for_seconds(seconds));
}

TEST(ImpactTimes, AgreeWithTheReferenceInEveryCase) {
  const auto cases = rows_by_case();
  EXPECT_EQ(cases.size(), 8u);
  for (const auto& [name, rows] : cases) {
    SCOPED_TRACE(name);
    const double last = support::number(rows.back(), "time");
    const RecordedRun run = run_scene(support::reference_scene(name), last * (1.0 + 1e-9));
    ASSERT_EQ(run.events.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      // One rounding of the modal data moves no time by more than 2.5e-13.
      EXPECT_NEAR(run.events[i].time, support::number(rows[i], "time"), 1e-11)
          << "impact " << i + 1;
      EXPECT_NEAR(run.events[i].speed / support::number(rows[i], "speed"), 1.0, 1e-10)
          << "impact " << i + 1;
    }
  }
}

struct Printed {
  std::size_t impact;
  double time, speed;
  double half_digit = 0.0;  // rounding of the printed speed, where it is short of 1e-10
};

void expect_printed(const RecordedRun& run, const std::vector<Printed>& printed) {
  for (const Printed& expected : printed) {
    ASSERT_GE(run.events.size(), expected.impact);
    const Event& event = run.events[expected.impact - 1];
    EXPECT_NEAR(event.time, expected.time, 1e-11) << "impact " << expected.impact;
    EXPECT_NEAR(event.speed, expected.speed, 1e-10 * expected.speed + expected.half_digit)
        << "impact " << expected.impact;
  }
}

TEST(ImpactTimes, OfThePublishedBeamWithTheCollocationLaw) {
  const RecordedRun run = run_scene(support::shipped_scene("01_wagg_2004"), 1.1);
  expect_printed(run, {{1, 0.13563198510325340, 0.0476954723114963},
                       {5, 0.33369887121759930, 0.0278855061652316},
                       {14, 1.03009235278016, 0.02265384824, 5e-12}});
}

TEST(ImpactTimes, OfThePublishedBeamWithTheMomentumLaw) {
  const RecordedRun run = run_scene(support::shipped_scene("02_wagg_momentum"), 1.0);
  expect_printed(run, {{1, 0.13575577310536956, 0.0473040851227817},
                       {5, 0.33128692895001645, 0.0533561093385891},
                       {14, 0.53215503685619719, 0.027523026794435},
                       {25, 0.54069262518025671, 0.00406650858593444}});
}

// One piece makes elements of a beam that has a closed form.
TEST(ImpactTimes, OfTheSameBeamByElements) {
  const RecordedRun closed = run_scene(support::shipped_scene("02_wagg_momentum"), 0.53);
  const RecordedRun pieced =
      run_scene(support::shipped_scene("02_wagg_momentum", {"beam.piece=[{}]"}), 0.53);
  ASSERT_GE(closed.events.size(), 10u);
  ASSERT_GE(pieced.events.size(), 10u);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_NEAR(pieced.events[i].time, closed.events[i].time, 1e-9) << i;
    EXPECT_NEAR(pieced.events[i].speed, closed.events[i].speed, 1e-9) << i;
  }
}

TEST(ImpactTimes, ThePublishedBeamComesToRestOnItsStop) {
  const Scene scene = support::shipped_scene("02_wagg_momentum");
  const RecordedRun run = run_scene(scene, 1.0);
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd);
  const auto stick = std::find_if(run.events.begin(), run.events.end(),
                                  [](const Event& e) { return e.kind == EventKind::kStick; });
  ASSERT_NE(stick, run.events.end());
  EXPECT_NEAR(stick->time, 0.541289, 1e-6);
  EXPECT_EQ(std::prev(stick)->kind, EventKind::kChatter);
  // Chatter: speeds fall by no more than r each in the end, and times never go back.
  for (std::size_t i = 1; i < run.events.size(); ++i)
    EXPECT_GE(run.events[i].time, run.events[i - 1].time);
}

TEST(ImpactTimes, EveryImpactOfTheMomentumLawLosesItsShareOfEnergy) {
  const Scene scene = support::shipped_scene("02_wagg_momentum");
  const System system = assemble(scene);
  const RecordedRun run = run_scene(scene, 0.54);
  double lost = 0.0;
  for (const Event& event : run.events) {
    if (event.kind != EventKind::kImpact) continue;
    const double expected =
        -0.5 * (1.0 - 0.64) * event.speed * event.speed / system.stops[0].row.squaredNorm();
    EXPECT_NEAR(event.energy_change / expected, 1.0, 1e-12);
    lost -= event.energy_change;
  }
  EXPECT_EQ(run.result.totals.energy_added, 0.0);
  EXPECT_NEAR(run.result.totals.energy_lost / lost, 1.0, 1e-13);
}

TEST(ImpactTimes, TheCollocationLawEntersTheEnergyItAdds) {
  const RecordedRun run = run_scene(support::shipped_scene("01_wagg_2004"), 10.0);
  double added = 0.0, lost = 0.0;
  for (const Event& event : run.events)
    (event.energy_change > 0.0 ? added : lost) += std::abs(event.energy_change);
  EXPECT_NEAR(run.result.totals.energy_added, added, 1e-15);
  EXPECT_NEAR(run.result.totals.energy_lost, lost, 1e-15);
  EXPECT_GT(added, 0.0);
}

}  // namespace
}  // namespace graze
