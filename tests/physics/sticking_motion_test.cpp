// Chatter, sticking and release against tests/reference/sticking_motion.csv: runs at 60 digits,
// with every impact of a chatter followed until nothing is left of it.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::number;
using support::TableRow;

EventKind kind_of(const std::string& name) {
  return name == "impact"  ? EventKind::kImpact
         : name == "stick" ? EventKind::kStick
                           : EventKind::kRelease;
}

// Largest errors of a run, time in s and speed relative to the largest.
struct Miss {
  double time = 0.0, speed = 0.0;
};

Miss expect_events(const std::string& name, const std::vector<TableRow>& rows, double tolerance) {
  SCOPED_TRACE(name);
  const Scene scene = support::reference_scene("sticking/" + name);
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  const support::RecordedRun run =
      support::record_run(system, start, support::for_seconds(number(rows.back(), "time") + 1e-3));
  Miss miss;
  double largest = 0.0;
  for (const TableRow& row : rows)
    if (row.at("kind") == "impact") largest = std::max(largest, number(row, "speed"));
  std::size_t at = 0;
  for (const TableRow& row : rows) {
    const EventKind kind = kind_of(row.at("kind"));
    const int stop = static_cast<int>(number(row, "stop")) - 1;
    // The table leaves out the last, slow impacts of a chatter.
    if (kind == EventKind::kStick)
      while (at < run.events.size() && (run.events[at].kind == EventKind::kImpact ||
                                        run.events[at].kind == EventKind::kChatter))
        ++at;
    if (at == run.events.size()) {
      ADD_FAILURE() << "no event for row " << row.at("event");
      return miss;
    }
    const Event& event = run.events[at++];
    EXPECT_EQ(event.kind, kind) << "row " << row.at("event");
    EXPECT_EQ(event.stop, stop) << "row " << row.at("event");
    if (event.kind != kind) return miss;
    miss.time = std::max(miss.time, std::abs(event.time - number(row, "time")));
    if (kind == EventKind::kImpact)
      miss.speed = std::max(miss.speed, std::abs(event.speed - number(row, "speed")) / largest);
  }
  EXPECT_LE(miss.time, tolerance);
  EXPECT_LE(miss.speed, tolerance);
  return miss;
}

TEST(StickingMotion, EventsAreThoseOfSixtyDigits) {
  std::map<std::string, std::vector<TableRow>> cases;
  for (const TableRow& row : support::read_table("sticking_motion.csv"))
    cases[row.at("case")].push_back(row);
  for (const auto& [name, rows] : cases) {
    const Miss miss = expect_events(name, rows, 1e-9);
    std::printf("%-12s time %.1e speed %.1e\n", name.c_str(), miss.time, miss.speed);
  }
}

}  // namespace
}  // namespace graze
