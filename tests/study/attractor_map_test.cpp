// Maps of what the motion settles on: basins against closed forms and single runs, planes of
// parameters against sweeps.
#include "graze/study/plane/attractor_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/errors.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/study/sweep/sweep.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// x'' + 0.1 x' + x = F cos(1.6 t), stop at 0.5, r = 0.8: between the fold at F = 0.2767 and the
// grazing at 0.7841 it may stay clear or hit the stop once a period.
Scene bistable() {
  return support::shipped_scene(
      "04_impact_oscillator",
      {"forcing.frequency=1.6", "stop.gap=0.5", "initial.q=[0.0]", "forcing.amplitude=0.5"});
}

AttractorMapOptions basins(int points) {
  AttractorMapOptions options;
  options.x = {"initial.q.1", -2.0, 0.45, points};
  options.y = {"initial.qdot.1", -2.0, 2.0, points};
  return options;
}

TEST(AttractorMap, StartsNearTheFreeMotionStayClear) {
  const AttractorMap map = map_attractors(bistable(), basins(41));
  ASSERT_EQ(map.attractors.size(), 2u);
  EXPECT_TRUE(map.is_of_starts);
  // The steady response P e^{i 1.6 t}; what a start differs from it never grows in x^2 + x'^2.
  const std::complex<double> response = 0.5 / std::complex<double>(1.0 - 1.6 * 1.6, 0.1 * 1.6);
  int inside = 0, hitting = 0;
  for (int row = 0; row < 41; ++row)
    for (int column = 0; column < 41; ++column) {
      const MapCell& cell = map.at(column, row);
      ASSERT_TRUE(cell.is_known);
      ASSERT_GE(cell.place, 0);
      hitting += cell.attractor.kind == SettledKind::kImpacts;
      const double u = map.options.x.value(column) - response.real();
      const double rate =
          map.options.y.value(row) - (std::complex<double>(0.0, 1.6) * response).real();
      if (std::abs(response) + std::hypot(u, rate) >= 0.5) continue;
      ++inside;
      EXPECT_EQ(cell.attractor.kind, SettledKind::kClear) << column << " " << row;
      EXPECT_EQ(cell.peak_speed, 0.0);
      EXPECT_EQ(cell.impacts_per_period, 0.0);
    }
  EXPECT_GT(inside, 3);
  EXPECT_GT(hitting, 100);
  EXPECT_EQ(map.attractors[0].cells + map.attractors[1].cells, 41u * 41u);
}

TEST(AttractorMap, CellsAreSingleRuns) {
  const Scene scene = bistable();
  const AttractorMap map = map_attractors(scene, basins(41));
  std::mt19937 random(3);
  std::uniform_int_distribution<int> any(0, 40);
  for (int i = 0; i < 1000; ++i) {
    const int column = any(random), row = any(random);
    Scene one = scene;
    one.initial->q = {map.options.x.value(column)};
    one.initial->qdot = {map.options.y.value(row)};
    const System system = assemble(one);
    const support::RecordedRun run = support::record_run(
        system, initial_state(one, system), support::for_seconds(400.0 * system.period()));
    long long late = 0;
    for (const Event& event : run.events)
      late += event.kind == EventKind::kImpact && event.time > 390.0 * system.period();
    EXPECT_EQ(late > 0, map.at(column, row).attractor.kind == SettledKind::kImpacts)
        << column << " " << row;
    if (late > 0) {
      EXPECT_NEAR(run.events.back().speed, map.at(column, row).peak_speed, 1e-6);
    }
  }
}

TEST(AttractorMap, RowsAreFreshSweeps) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode");
  AttractorMapOptions options;
  options.x = {"forcing.frequency", 20.0, 110.0, 16};
  options.y = {"stop.gap", 0.5e-3, 1.5e-3, 3};
  options.exponent_periods = 50;
  const AttractorMap map = map_attractors(scene, options);
  EXPECT_FALSE(map.is_of_starts);
  for (int row = 0; row < 3; ++row) {
    const Scene own = support::shipped_scene("05_wagg_one_mode",
                                             {"stop.gap=" + std::to_string(options.y.value(row))});
    SweepOptions sweeping;
    sweeping.from = 20.0;
    sweeping.to = 110.0;
    sweeping.points = 16;
    sweeping.direction = SweepDirection::kFresh;
    sweeping.exponent_periods = 50;
    const Sweep swept = sweep(SystemFamily(own, "forcing.frequency"), sweeping);
    for (int column = 0; column < 16; ++column) {
      const MapCell& cell = map.at(column, row);
      const SweepRow& other = swept.rows[static_cast<std::size_t>(column)];
      EXPECT_EQ(cell.attractor, attractor_class(other)) << column << " " << row;
      if (other.status == SweepStatus::kSettled && other.exponents) {
        EXPECT_EQ(*cell.exponent, other.exponents->values[0]);
      }
    }
  }
}

// A motion kept starts on what its cell settles on: followed for its period it is back there.
void expect_back(const Scene& scene, const AttractorMap& map, const CellMotion& motion) {
  const System system = assemble(scene_at(scene, map.options, motion.cell));
  const double duration = map.cells[motion.cell].attractor.period * system.period();
  const support::RecordedRun run =
      support::record_run(system, motion.start, support::for_seconds(duration));
  const State& end = run.result.final;
  // Within 1e-8 of the orbit at its impacts, in phases and relative speeds; between them, where one
  // is slow, within a hundred times as much.
  const MotionScale scale = motion_scale(system);
  const Vector moved = (end.q - motion.start.q) / scale.displacement,
               faster = (end.qdot - motion.start.qdot).cwiseQuotient(scale.velocity);
  EXPECT_LT(moved.cwiseAbs().maxCoeff(), 1e-5) << motion.cell;
  EXPECT_LT(faster.cwiseAbs().maxCoeff(), 1e-5) << motion.cell;
}

TEST(AttractorMap, KeepsMotionsSpreadOverThePlane) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode");
  AttractorMapOptions options;
  options.x = {"forcing.frequency", 20.0, 110.0, 41};
  options.y = {"stop.gap", 0.5e-3, 1.5e-3, 21};
  options.periods = 300;
  const AttractorMap map = map_attractors(scene, options);
  // Of 41 by 21 cells every third column, from the second on, and every row are the most below 400.
  ASSERT_EQ(map.motions.size(), 14u * 21u);
  int settled = 0;
  for (std::size_t k = 0; k < map.motions.size(); ++k) {
    const CellMotion& motion = map.motions[k];
    EXPECT_EQ(motion.cell, 1 + 3 * (k % 14) + 41 * (k / 14));
    if (map.cells[motion.cell].attractor.status != SweepStatus::kSettled) continue;
    ++settled;
    expect_back(scene, map, motion);
  }
  EXPECT_GT(settled, 100);
}

TEST(AttractorMap, KeepsAMotionOfEveryBasin) {
  const AttractorMap map = map_attractors(bistable(), basins(21));
  ASSERT_EQ(map.motions.size(), map.attractors.size());
  for (std::size_t k = 0; k < map.motions.size(); ++k) {
    EXPECT_EQ(map.motions[k].cell, map.attractors[k].first);
    expect_back(bistable(), map, map.motions[k]);
  }
}

TEST(AttractorMap, IsTheSameForAnyNumberOfThreads) {
  AttractorMapOptions options = basins(12);
  options.threads = 1;
  const AttractorMap alone = map_attractors(bistable(), options);
  options.threads = 3;
  const AttractorMap together = map_attractors(bistable(), options);
  for (std::size_t i = 0; i < alone.cells.size(); ++i) {
    EXPECT_EQ(alone.cells[i].place, together.cells[i].place);
    EXPECT_EQ(alone.cells[i].peak_speed, together.cells[i].peak_speed);
  }
}

// On two stops alike an orbit that favours one has a twin that favours the other: both do the same,
// and yet are two.
TEST(AttractorMap, TwinsAreTwoAttractors) {
  const Scene scene = support::shipped_scene("07_two_stops");
  AttractorMapOptions options;
  options.x = {"initial.q.1", -1e-4, 1e-4, 6};
  options.y = {"initial.qdot.1", -0.02, 0.02, 6};
  const AttractorMap map = map_attractors(scene, options);
  for (const MapCell& cell : map.cells) EXPECT_TRUE(cell.is_known);
  for (std::size_t i = 1; i < map.attractors.size(); ++i)
    EXPECT_GE(map.attractors[i - 1].cells, map.attractors[i].cells);
}

TEST(AttractorMap, StuckPartIsThatOfTheTime) {
  // Pressed for part of every period: settles on one that sticks.
  AttractorMapOptions options;
  options.x = {"stop.restitution", 0.05, 0.3, 2};
  options.y = {"forcing.frequency", 0.2, 0.3, 2};
  const Scene scene = support::shipped_scene("04_impact_oscillator", {"stop.gap=0.1"});
  const AttractorMap map = map_attractors(scene, options);
  int stuck = 0;
  for (const MapCell& cell : map.cells) {
    if (cell.attractor.kind != SettledKind::kSticks) continue;
    ++stuck;
    EXPECT_GT(cell.stuck_part, 0.05);
    EXPECT_LT(cell.stuck_part, 0.95);
    EXPECT_FALSE(cell.impacts_per_period);
  }
  EXPECT_GE(stuck, 1);
}

TEST(AttractorMap, RefusesAxesThatTheSceneDoesNotHave) {
  AttractorMapOptions options = basins(4);
  options.x.name = "initial.q.2";
  EXPECT_THROW(map_attractors(bistable(), options), InputError);
  options.x.name = "stop.gape";
  EXPECT_THROW(map_attractors(bistable(), options), InputError);
  options.x = options.y;
  EXPECT_THROW(map_attractors(bistable(), options), InputError);
}

// Beyond the stop there is nothing to start from.
TEST(AttractorMap, StartsBeyondAStopSaySo) {
  AttractorMapOptions options = basins(8);
  options.x.to = 0.9;
  const AttractorMap map = map_attractors(bistable(), options);
  for (int column = 0; column < 8; ++column) {
    const bool beyond = map.options.x.value(column) > 0.5;
    EXPECT_EQ(map.at(column, 3).attractor.status == SweepStatus::kNoStart, beyond);
    if (beyond) {
      EXPECT_NE(map.at(column, 3).message, "");
    }
  }
}

}  // namespace
}  // namespace graze
