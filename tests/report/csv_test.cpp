#include "graze/report/csv/csv.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "graze/report/text/detail/table.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

std::vector<std::string> cells_of(std::string row) {
  EXPECT_EQ(row.back(), '\n');
  row.pop_back();
  return support::split_cells(row);
}

TEST(EventsCsv, KeepsEveryDigitAndLeavesWhatDoesNotExistEmpty) {
  EXPECT_EQ(events_csv_header(),
            "kind,time,stop,speed,phase,energy_change,impacts,closure_speed,force,duration,"
            "peak_force,effective_restitution,friction,direction\n");
  Event event;
  event.time = 0.1 + 0.2;
  event.speed = 1.0 / 3.0;
  event.energy_change = -std::numeric_limits<double>::min();
  const std::vector<std::string> cell = cells_of(events_csv_row(event));
  ASSERT_EQ(cell.size(), 14U);
  EXPECT_EQ(cell[0], "impact");
  EXPECT_EQ(std::stod(cell[1]), event.time);
  EXPECT_EQ(cell[2], "1");
  EXPECT_EQ(std::stod(cell[3]), event.speed);
  EXPECT_EQ(std::stod(cell[5]), event.energy_change);
  for (const std::size_t i : {4U, 6U, 7U, 8U, 9U, 10U, 11U, 12U, 13U}) EXPECT_EQ(cell[i], "") << i;
}

TEST(EventsCsv, EveryKindFillsItsOwnColumns) {
  Event event;
  event.time = 1.5;
  event.stop = 2;
  event.speed = 0.25;
  event.phase = 0.75;
  event.energy_change = -0.5;
  event.impacts = 12;
  event.closure_speed = 0.125;
  event.force = 4.5;
  event.duration = 0.0625;
  event.peak_force = 8.5;
  event.effective_restitution = 0.875;
  const auto row = [&](EventKind kind) {
    event.kind = kind;
    return events_csv_row(event);
  };
  EXPECT_EQ(row(EventKind::kImpact), "impact,1.5,3,0.25,0.75,-0.5,,,,,,,,\n");
  EXPECT_EQ(row(EventKind::kChatter), "chatter,1.5,3,,,-0.5,12,0.125,,,,,,\n");
  EXPECT_EQ(row(EventKind::kStick), "stick,1.5,3,,,,,,4.5,,,,,\n");
  EXPECT_EQ(row(EventKind::kRelease), "release,1.5,3,,,,,,,,,,,\n");
  EXPECT_EQ(row(EventKind::kContact), "contact,1.5,3,0.25,0.75,,,,,,,,,\n");
  EXPECT_EQ(row(EventKind::kSeparation), "separation,1.5,3,0.25,,-0.5,,,,0.0625,8.5,0.875,,\n");
  event.stop = -1;
  event.friction = 1;
  event.direction = -1;
  EXPECT_EQ(row(EventKind::kSlip), "slip,1.5,,,,,,,,,,,2,-1\n");
}

TEST(SamplesCsv, HoldsStateGapsAndForces) {
  System system = support::oscillator(2.0, 0.0, 0.5, 0.8);
  system.stops.push_back({-Vector::Ones(1), 0.25, ImpactLaw{-Vector::Ones(1), 0.8}});
  Sample sample{1.5, support::state_of({0.125}, {-2.0}), 0.0, {0.0, 3.5}, {}};
  EXPECT_EQ(samples_csv_header(system, false), "time,q1,qdot1,gap1,gap2,force1,force2\n");
  EXPECT_EQ(samples_csv_row(system, sample), "1.5,0.125,-2,0.375,0.375,0,3.5\n");
}

TEST(SamplesCsv, HoldsTheEntriesOfTheEnergyBalanceThatTheSystemHas) {
  System system = support::oscillator(2.0, 0.0, 0.5, 0.8);
  Sample sample{0.0, support::state_of({0.125}, {-2.0}), 0.0, {0.0}, EnergyBalance{}};
  sample.energy->now = 2.03125;
  sample.energy->work = {0.5, 0.25, 0.125, 0.75, -0.375};
  sample.energy->impacts = -1.5;
  EXPECT_EQ(samples_csv_header(system, true),
            "time,q1,qdot1,gap1,force1,energy,work_forcing,work_load,work_constraint,work_impacts,"
            "dissipation,work_contact\n");
  EXPECT_EQ(samples_csv_row(system, sample), "0,0.125,-2,0.375,0,2.03125,,,0.125,-1.5,,\n");
  system.modal().delta[0] = 0.1;
  system.modal().load = Vector::Ones(1);
  system = support::forced(system, 1.0, 0.0, Vector::Ones(1));
  EXPECT_EQ(samples_csv_row(system, sample),
            "0,0.125,-2,0.375,0,2.03125,0.5,0.25,0.125,-1.5,0.75,\n");
  system.stops[0].law = ContactForce{};
  EXPECT_EQ(samples_csv_row(system, sample), "0,0.125,-2,0.375,0,2.03125,0.5,0.25,,,0.75,-0.375\n");
}

TEST(SamplesCsv, EndsWithTheProbes) {
  const System system = support::oscillator(2.0, 0.0, 0.5, 0.8);
  Sample sample{0.5, support::state_of({0.125}, {-2.0}), 0.0, {0.0}, EnergyBalance{}};
  const std::vector<ProbeRow> probes = {
      {ProbeQuantity::kDisplacement, Vector::Constant(1, 4.0), false, 0.0},
      {ProbeQuantity::kVelocity, Vector::Constant(1, 0.25), true, 0.0}};
  const std::string header = samples_csv_header(system, true, probes);
  EXPECT_EQ(header.substr(header.rfind("work_contact")), "work_contact,probe_1,probe_2\n");
  EXPECT_EQ(samples_csv_header(system, false, probes),
            "time,q1,qdot1,gap1,force1,probe_1,probe_2\n");
  EXPECT_EQ(samples_csv_row(system, sample, probes), "0.5,0.125,-2,0.375,0,0,,,0,0,,,0.5,-0.5\n");
  sample.energy.reset();
  EXPECT_EQ(samples_csv_row(system, sample, probes), "0.5,0.125,-2,0.375,0,0.5,-0.5\n");
}

TEST(Table, ColumnsLineUpOnTheRight) {
  Table table({"a", "long"});
  table.add({"123", "4"});
  EXPECT_EQ(table.text(100), "    a   long\n  123      4\n");
}

}  // namespace
}  // namespace graze
