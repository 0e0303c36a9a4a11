// The document and the printed table of a run, whose events are never all in memory.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "graze/record/records.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/text.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using Json = nlohmann::ordered_json;

Event event_of(EventKind kind, double time, int stop) {
  Event event;
  event.kind = kind;
  event.time = time;
  event.stop = stop;
  event.speed = 1e-6;
  event.energy_change = -1.0 / 3.0;
  event.impacts = 12;
  event.closure_speed = 1e-5;
  event.force = 0.1 + 0.2;
  return event;
}

SimulationRecord record_of_run() {
  SimulationRecord record;
  record.info = run_info("simulate", "a \"name\"\n \"events\": []", Scene{});
  record.info.options = {{"record", std::string("events")}};
  record.system = support::oscillator(1.0, 0.0, 0.5, 0.8);
  record.run.end_time = 2.0;
  record.run.final = support::state_of({0.5}, {0.0});
  record.run.stuck = {0};
  record.run.forces = {9.81};
  record.run.totals.smallest_gap = 0.0;
  record.outcome = {"interrupted", "stopped,\n \"events\": [] or not"};
  record.warnings = {"\n \"events\": []"};
  return record;
}

std::string document_of(const SimulationRecord& record, const std::vector<Event>& events) {
  Spool spool(".");
  for (const Event& event : events) add_event_json(event, spool);
  std::string text;
  to_json(record, spool).read([&](std::string_view piece) { text += piece; });
  return text;
}

TEST(SimulationDocument, IsTheSameAsOneWrittenInOnePiece) {
  Event no_phase = event_of(EventKind::kImpact, 1.0, 0);
  Event phase = event_of(EventKind::kImpact, 1e-7, 1);
  phase.phase = 6.0;
  phase.energy_change = std::nan("");
  const std::vector<std::vector<Event>> runs = {
      {},
      {no_phase},
      {phase, no_phase, event_of(EventKind::kChatter, 2.5, 0), event_of(EventKind::kStick, 3.0, 0),
       event_of(EventKind::kRelease, 4.0, 0)}};
  for (const std::vector<Event>& events : runs) {
    const std::string text = document_of(record_of_run(), events);
    const Json document = Json::parse(text);
    EXPECT_EQ(text, document.dump(1) + "\n");
    EXPECT_EQ(document["events"].size(), events.size());
  }
}

TEST(SimulationDocument, EveryKindOfEventHasItsKeys) {
  const Json document = Json::parse(
      document_of(record_of_run(),
                  {event_of(EventKind::kImpact, 1.0, 0), event_of(EventKind::kChatter, 2.0, 1),
                   event_of(EventKind::kStick, 3.0, 1), event_of(EventKind::kRelease, 4.0, 0)}));
  EXPECT_EQ(document["events"], Json::parse(R"([
    {"kind": "impact", "time": 1.0, "stop": 1, "speed": 1e-6, "phase": null,
     "energy_change": -0.33333333333333331},
    {"kind": "chatter", "time": 2.0, "stop": 2, "energy_change": -0.33333333333333331,
     "impacts": 12, "closure_speed": 1e-5},
    {"kind": "stick", "time": 3.0, "stop": 2, "force": 0.30000000000000004},
    {"kind": "release", "time": 4.0, "stop": 1}])"));
}

TEST(SimulationDocument, HoldsTheEndAndTheTotals) {
  SimulationRecord record = record_of_run();
  record.run.totals = {7, 2, 3, 4, 0.5, 0.25, 0.125, -1e-18};
  const Json document = Json::parse(document_of(record, {}));
  EXPECT_EQ(document["outcome"], "interrupted");
  EXPECT_EQ(document["final"], Json::parse(R"({"time": 2.0, "q": [0.5], "qdot": [0.0],
                                               "stuck": [1], "forces": [9.81]})"));
  EXPECT_EQ(document["totals"], Json::parse(R"({"impacts": 7, "chatters": 2, "stuck_time": 0.5,
      "energy_added_by_impacts": 0.25, "energy_lost_by_impacts": 0.125, "smallest_gap": -1e-18,
      "undecided_touches": 4, "clamped_restitutions": 3})"));
  EXPECT_FALSE(document.contains("energy"));
}

TEST(SimulationDocument, EnergyIsNullForWhatTheSystemDoesNotHave) {
  SimulationRecord record = record_of_run();
  EnergyBalance balance;
  balance.start = 1.0;
  balance.impacts = -0.25;
  balance.now = 0.75;
  record.run.energy = balance;
  EXPECT_EQ(Json::parse(document_of(record, {}))["energy"], Json::parse(R"({"start": 1.0,
      "forcing": null, "load": null, "constraint": 0.0, "impacts": -0.25, "dissipation": null,
      "end": 0.75, "defect": 0.0, "relative_defect": 0.0})"));
  record.system.stops.clear();
  record.system.modal().load = Vector::Ones(1);
  record.system.modal().delta[0] = 0.1;
  record.run.energy->work = {0.0, 2.0, 0.0, 0.5};
  record.run.energy->impacts = 0.0;
  // 1 + 2 - 0.5 - 0.75 = 1.75 is missing, of 2.
  EXPECT_EQ(Json::parse(document_of(record, {}))["energy"], Json::parse(R"({"start": 1.0,
      "forcing": null, "load": 2.0, "constraint": null, "impacts": null, "dissipation": 0.5,
      "end": 0.75, "defect": 1.75, "relative_defect": 0.875})"));
}

int rows_in(const std::string& text, const std::string& word) {
  int count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++count;
  return count;
}

TEST(SimulationText, ShowsTheFirstAndTheLastEvents) {
  for (const int count : {0, 1, 10, 20, 21, 22, 1000}) {
    SimulationRecord record = record_of_run();
    for (int i = 1; i <= count; ++i) record.excerpt.add(event_of(EventKind::kImpact, i, 0));
    const std::string text = to_text(record);
    EXPECT_EQ(rows_in(text, " impact "), count <= 21 ? count : 20) << count;
    EXPECT_EQ(rows_in(text, "  ..\n") + rows_in(text, "  .. "), count <= 21 ? 0 : 1) << count;
    if (count == 0) continue;
    // The number of an event and its time are the same here.
    std::istringstream lines(text);
    std::string line, last;
    while (std::getline(lines, line) && !line.empty()) last = line;
    std::istringstream cells(last);
    int number = 0;
    double time = 0.0;
    cells >> number >> line >> time;
    EXPECT_EQ(number, count);
    EXPECT_EQ(time, count);
  }
}

TEST(SimulationText, SaysWhatHoldsTheStructureAtTheEnd) {
  const std::string text = to_text(record_of_run());
  EXPECT_NE(text.find("at rest at the end on    stop 1, force 9.81 N\n"), std::string::npos);
  EXPECT_NE(text.find("interrupted: stopped"), std::string::npos);
}

TEST(SimulationWarnings, TellEnergyFromRounding) {
  const System system = support::oscillator(1.0, 0.0, 0.5, 1.0);
  Simulation run;
  run.final = support::state_of({0.0}, {1.0});
  run.totals.impacts = 10;
  run.totals.energy_added = 1e-15;
  EXPECT_TRUE(simulation_warnings(system, run).empty());
  run.totals.energy_added = 1e-12;
  ASSERT_EQ(simulation_warnings(system, run).size(), 1U);
  run.totals.clamped_restitutions = 2;
  EXPECT_EQ(simulation_warnings(system, run).back(),
            "the restitution r(v) left 0 to 1 at 2 impacts and was clamped");
}

}  // namespace
}  // namespace graze
