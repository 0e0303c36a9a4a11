#include "graze/report/csv.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "graze/report/table.hpp"

namespace graze {
namespace {

SimulationRecord record_with(const std::vector<Event>& events) {
  SimulationRecord record;
  record.system.omega = Vector::Ones(1);
  record.events = events;
  return record;
}

TEST(EventsCsv, KeepsEveryDigitAndLeavesWhatDoesNotExistEmpty) {
  Event event;
  event.time = 0.1 + 0.2;
  event.speed = 1.0 / 3.0;
  event.energy_change = -std::numeric_limits<double>::min();
  std::istringstream text(events_csv(record_with({event})));
  std::string header, row;
  std::getline(text, header);
  std::getline(text, row);
  EXPECT_EQ(header, "kind,time,stop,speed,phase,energy_change");
  std::istringstream cells(row);
  std::vector<std::string> cell(6);
  for (std::string& c : cell) std::getline(cells, c, ',');
  EXPECT_EQ(cell[0], "impact");
  EXPECT_EQ(std::stod(cell[1]), event.time);
  EXPECT_EQ(cell[2], "1");
  EXPECT_EQ(std::stod(cell[3]), event.speed);
  EXPECT_EQ(cell[4], "");
  EXPECT_EQ(std::stod(cell[5]), event.energy_change);
}

TEST(Table, ColumnsLineUpOnTheRight) {
  Table table({"a", "long"});
  table.add({"123", "4"});
  EXPECT_EQ(table.text(), "    a   long\n  123      4\n");
}

}  // namespace
}  // namespace graze
