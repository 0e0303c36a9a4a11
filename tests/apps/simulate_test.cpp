// graze simulate: what a run leaves on stdout and in its folder, and how it ends.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "apps/program.hpp"
#include "graze/fem/detail/numpy_array.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

using nlohmann::json;

const std::string kPreloaded = scene("08_preloaded_oscillator.toml");

json simulated(const std::string& arguments, int code = 0) {
  const Finished run = run_graze("simulate --json " + arguments);
  EXPECT_EQ(run.code, code) << run.err;
  return json::parse(run.out);
}

std::set<std::string> keys_of(const json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

std::vector<json> events_of(const json& document, const std::string& kind) {
  std::vector<json> events;
  for (const json& event : document["events"])
    if (event["kind"] == kind) events.push_back(event);
  return events;
}

TEST(Simulate, ReportsEveryImpactAndTheEnd) {
  const json document = simulated("--duration 0.5 " + kMomentum);
  EXPECT_EQ(document["outcome"], "reached_end");
  EXPECT_FALSE(document.contains("message"));
  EXPECT_EQ(document["final"]["time"], 0.5);
  EXPECT_EQ(document["final"]["q"].size(), 4U);
  EXPECT_EQ(document["totals"]["impacts"], document["events"].size());
  const json& first = document["events"][0];
  // Independent 40-digit values.
  EXPECT_NEAR(first["time"].get<double>(), 0.13575577310536956, 1e-11);
  EXPECT_NEAR(first["speed"].get<double>(), 0.0473040851227817, 1e-11);
  EXPECT_LT(first["energy_change"].get<double>(), 0.0);
}

TEST(Simulate, DocumentsHaveTheContractsKeys) {
  const json document = simulated("--duration 2 --energy " + kMomentum);
  const std::map<std::string, std::set<std::string>> keys = {
      {"impact", {"kind", "time", "stop", "speed", "phase", "energy_change"}},
      {"chatter", {"kind", "time", "stop", "impacts", "closure_speed", "energy_change"}},
      {"stick", {"kind", "time", "stop", "force"}},
      {"release", {"kind", "time", "stop"}}};
  std::set<std::string> kinds;
  for (const json& event : document["events"]) {
    kinds.insert(event["kind"]);
    EXPECT_EQ(keys_of(event), keys.at(event["kind"])) << event;
  }
  EXPECT_EQ(kinds.size(), 4U);
  EXPECT_EQ(keys_of(document["final"]),
            (std::set<std::string>{"time", "q", "qdot", "stuck", "forces"}));
  EXPECT_EQ(keys_of(document["totals"]),
            (std::set<std::string>{"impacts", "chatters", "stuck_time", "energy_added_by_impacts",
                                   "energy_lost_by_impacts", "smallest_gap", "undecided_touches",
                                   "clamped_restitutions"}));
  EXPECT_EQ(keys_of(document["energy"]),
            (std::set<std::string>{"start", "forcing", "load", "constraint", "impacts",
                                   "dissipation", "end", "defect", "relative_defect"}));
}

TEST(Simulate, ClosedChatterIsFollowedByItsStickAndRelease) {
  const json document = simulated("--duration 0.6 " + kMomentum);
  const json& events = document["events"];
  std::size_t at = 0;
  while (at < events.size() && events[at]["kind"] != "chatter") ++at;
  ASSERT_LT(at + 2, events.size());
  EXPECT_EQ(events[at - 1]["kind"], "impact");
  EXPECT_EQ(events[at]["time"], events[at - 1]["time"]);
  EXPECT_LE(events[at - 1]["speed"], events[at]["closure_speed"]);
  EXPECT_GT(events[at]["impacts"], 10);
  // tests/reference/sticking_motion.csv, beam4.
  EXPECT_EQ(events[at + 1]["kind"], "stick");
  EXPECT_NEAR(events[at + 1]["time"].get<double>(), 0.54128945447628902607, 1e-12);
  EXPECT_GT(events[at + 1]["force"], 0.0);
  EXPECT_EQ(events[at + 2]["kind"], "release");
  EXPECT_NEAR(events[at + 2]["time"].get<double>(), 0.54345279560046882838, 1e-12);
  double before = 0.0;
  for (const json& event : events) {
    EXPECT_GE(event["time"], before);
    before = event["time"];
  }
}

TEST(Simulate, BallBouncesToRestAsTheClosedFormSays) {
  const double g = 9.81, h = 1.0, r = 0.8, drop = std::sqrt(2.0 * h / g);
  const json document = simulated("--duration 5 --energy " + kBall);
  const std::vector<json> impacts = events_of(document, "impact");
  ASSERT_GT(impacts.size(), 50U);
  double time = drop, speed = std::sqrt(2.0 * g * h);
  for (const json& impact : impacts) {
    EXPECT_NEAR(impact["time"].get<double>(), time, 1e-13);
    EXPECT_NEAR(impact["speed"].get<double>(), speed, 1e-13);
    EXPECT_NEAR(impact["energy_change"].get<double>(), -0.5 * (1.0 - r * r) * speed * speed, 1e-12);
    EXPECT_TRUE(impact["phase"].is_null());
    speed *= r;
    time += 2.0 * speed / g;
  }
  const std::vector<json> chatters = events_of(document, "chatter");
  ASSERT_EQ(chatters.size(), 1U);
  EXPECT_EQ(chatters[0]["impacts"], impacts.size());
  const json last = events_of(document, "stick").back();
  const double rest = 4.0637127688715781;  // sqrt(2 h/g) (1 + r)/(1 - r)
  EXPECT_NEAR(last["time"].get<double>() / rest, 1.0, 1e-12);
  EXPECT_NEAR(last["force"].get<double>(), g, 1e-12);
  EXPECT_EQ(document["final"]["stuck"], json::array({1}));
  EXPECT_NEAR(document["final"]["forces"][0].get<double>(), g, 1e-12);
  EXPECT_NEAR(document["totals"]["stuck_time"].get<double>(), 5.0 - rest, 1e-11);
  // The fall, m g h, goes into the floor.
  EXPECT_NEAR(document["energy"]["load"].get<double>(), g * h, 1e-12);
  EXPECT_NEAR(document["energy"]["impacts"].get<double>(), -g * h, 1e-12);
  EXPECT_NEAR(document["totals"]["energy_lost_by_impacts"].get<double>(), g * h, 1e-12);
  EXPECT_TRUE(document["energy"]["forcing"].is_null());
  EXPECT_TRUE(document["energy"]["dissipation"].is_null());
}

TEST(Simulate, ClosureSpeedIsTheUsersOrTheDefault) {
  const double r = 0.8, fastest = std::sqrt(2.0 * 9.81);
  for (const double closure : {1e-3, 0.1, -1.0}) {
    const bool given = closure > 0.0;
    const json document =
        simulated("--duration 5 " +
                  (given ? "--closure-speed " + std::to_string(closure) + " " : "") + kBall);
    // Default: sqrt(tolerance/100) of the speed after the fall.
    const double expected = given ? closure : 1e-6 * fastest;
    EXPECT_NEAR(document["graze"]["options"]["closure_speed"].get<double>(), expected,
                1e-12 * expected);
    const json chatter = events_of(document, "chatter").at(0);
    EXPECT_NEAR(chatter["closure_speed"].get<double>(), expected, 1e-12 * expected);
    // The first impact at or below it is the last.
    EXPECT_EQ(chatter["impacts"], 1 + std::ceil(std::log(expected / fastest) / std::log(r)));
    EXPECT_NEAR(events_of(document, "stick").at(0)["time"].get<double>(), 4.0637127688715781,
                1e-12);
  }
}

TEST(Simulate, PreloadedMassIsLiftedOffWhereTheLoadSays) {
  // The contact force is 0.2 + 0.3 cos(t/2).
  const json document = simulated("--duration 4 " + kPreloaded);
  EXPECT_EQ(document["events"], json::array());
  EXPECT_EQ(document["final"]["stuck"], json::array({1}));
  EXPECT_NEAR(document["final"]["forces"][0].get<double>(), 0.2 + 0.3 * std::cos(2.0), 1e-14);
  EXPECT_EQ(document["totals"]["stuck_time"], 4.0);
  const json longer = simulated("--periods 3 " + kPreloaded);
  const double period = 4.0 * std::acos(-1.0), first = 2.0 * std::acos(-2.0 / 3.0);
  const std::vector<json> releases = events_of(longer, "release");
  ASSERT_EQ(releases.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(releases[i]["time"].get<double>(), first + static_cast<double>(i) * period, 1e-12);
  // Started at rest on the stop, the spring stretched by 0.2.
  EXPECT_NEAR(simulated("--energy --duration 1 " + kPreloaded)["energy"]["start"].get<double>(),
              0.02, 1e-16);
}

TEST(Simulate, EnergyBalanceCloses) {
  for (const std::string& line : std::vector<std::string>{
           "--duration 2 " + kMomentum, "--duration 5 " + kBall, "--periods 3 " + kPreloaded,
           "--duration 2 " + scene("01_wagg_2004.toml"),
           "--duration 2 " + scene("07_two_stops.toml")}) {
    const json document = simulated("--energy " + line);
    const json& balance = document["energy"];
    EXPECT_LE(balance["relative_defect"], 1e-10) << line;
    const auto entry = [&](const char* key) {
      return balance[key].is_null() ? 0.0 : balance[key].get<double>();
    };
    const double missing = entry("start") + entry("forcing") + entry("load") + entry("constraint") +
                           entry("impacts") - entry("dissipation") - entry("end");
    EXPECT_NEAR(missing, entry("defect"), 1e-15 * std::abs(entry("end")) + 1e-20) << line;
    const json& totals = document["totals"];
    EXPECT_NEAR(entry("impacts"),
                totals["energy_added_by_impacts"].get<double>() -
                    totals["energy_lost_by_impacts"].get<double>(),
                1e-12 * std::abs(entry("impacts")));
  }
}

TEST(Simulate, SaysThatImpactsAddedEnergyAndThatRestitutionWasClamped) {
  const Finished oblique = run_graze("simulate --json --duration 2 " + scene("01_wagg_2004.toml"));
  const json document = json::parse(oblique.out);
  EXPECT_GT(document["totals"]["energy_added_by_impacts"], 0.0);
  EXPECT_NE(oblique.err.find("impacts added"), std::string::npos) << oblique.err;
  EXPECT_NE(document["warnings"].dump().find("impacts added"), std::string::npos);

  // r(v) = 0.9 - 50 v is negative beyond v = 0.018.
  const Finished clamped =
      run_graze("simulate --json --periods 20 --set 'stop.restitution=[0.9,50.0]' " + kOneMode);
  const json steep = json::parse(clamped.out);
  long long fast = 0;
  for (const json& event : events_of(steep, "impact")) fast += event["speed"] > 0.018 ? 1 : 0;
  EXPECT_GT(fast, 0);
  EXPECT_EQ(steep["totals"]["clamped_restitutions"], fast);
  EXPECT_NE(clamped.err.find(std::to_string(fast) + " impact"), std::string::npos) << clamped.err;
  EXPECT_TRUE(simulated("--duration 1 " + kMomentum).value("warnings", json::array()).empty());
}

TEST(Simulate, TablesHoldWhatTheDocumentHolds) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "run").string();
  const Finished run = run_graze(
      "simulate --json --duration 2 --energy --record samples "
      "--sample-rate 200 --out " +
      folder + " " + kMomentum);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(names_in(folder), (std::vector<std::string>{"events.csv", "record.json", "result.json",
                                                        "samples.csv", "scene.toml"}));
  EXPECT_EQ(read_text(folder + "/result.json"), run.out);
  const json document = json::parse(run.out);
  const std::vector<std::string> events = lines_of(folder + "/events.csv");
  ASSERT_EQ(events.size(), document["events"].size() + 1);
  EXPECT_EQ(events[0],
            "kind,time,stop,speed,phase,energy_change,impacts,closure_speed,force,duration,"
            "peak_force,effective_restitution,friction,direction");
  for (std::size_t i = 1; i < events.size(); ++i) {
    std::istringstream row(events[i]);
    for (const char* key : {"kind", "time", "stop", "speed", "phase", "energy_change", "impacts",
                            "closure_speed", "force"}) {
      std::string cell;
      std::getline(row, cell, ',');
      const json& event = document["events"][i - 1];
      if (!event.contains(key))
        EXPECT_EQ(cell, "") << key;
      else if (event[key].is_string())
        EXPECT_EQ(cell, event[key]);
      else
        EXPECT_EQ(std::stod(cell), event[key].get<double>()) << key;
    }
  }
  const std::vector<std::string> samples = lines_of(folder + "/samples.csv");
  EXPECT_EQ(samples.size(), 402U);
  EXPECT_EQ(samples[0],
            "time,q1,q2,q3,q4,qdot1,qdot2,qdot3,qdot4,gap1,force1,energy,work_forcing,work_load,"
            "work_constraint,work_impacts,dissipation,work_contact");
  EXPECT_EQ(samples.back().substr(0, 2), "2,");
}

// To the last bit: what the table's text says, and an empty cell is no number.
TEST(Simulate, ArraysOfSamplesHoldWhatTheirTableHolds) {
  const ScratchFolder scratch;
  const std::string table = (scratch / "table").string(), arrays = (scratch / "arrays").string();
  const std::string line = "simulate --duration 2 --energy --record samples " +
                           scene("16_strain_gauge.toml") + " --out ";
  ASSERT_EQ(run_graze(line + table).code, 0);
  ASSERT_EQ(run_graze(line + arrays + " --sample-format npz").code, 0);
  EXPECT_EQ(names_in(arrays), (std::vector<std::string>{"events.csv", "record.json", "result.json",
                                                        "samples.npz", "scene.toml"}));
  const std::vector<std::string> rows = lines_of(table + "/samples.csv");
  const std::vector<std::string> names = support::split_cells(rows[0]);
  const auto members = zip_members(arrays + "/samples.npz");
  ASSERT_EQ(members.size(), names.size());
  std::vector<NumpyArray> columns;
  for (const std::string& name : names) {
    columns.push_back(numpy_array(name, members.at(name + ".npy")));
    ASSERT_EQ(columns.back().values.size(), rows.size() - 1) << name;
  }
  int empty = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::vector<std::string> cells = support::split_cells(rows[i]);
    for (std::size_t j = 0; j < names.size(); ++j) {
      const double value = columns[j].values[i - 1];
      const std::string cell = j < cells.size() ? cells[j] : "";
      empty += cell.empty() ? 1 : 0;
      EXPECT_TRUE(cell.empty() ? std::isnan(value) : std::stod(cell) == value)
          << names[j] << ", row " << i << ": " << cell;
    }
  }
  EXPECT_GT(empty, 0);
}

TEST(Simulate, ArraysOfSamplesGoWithAFolder) {
  for (const char* options : {"--record samples", "--out run", ""}) {
    const Finished run = run_graze("simulate --sample-format npz " + kOneMode + " " + options);
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find("--sample-format: it needs --record samples and --out"),
              std::string::npos)
        << run.err;
  }
  EXPECT_EQ(run_graze("simulate --sample-format hdf " + kOneMode).code, 2);
}

// Of the shipped scene with a strain gauge: the last two columns, and their units.
TEST(Simulate, ProbesAreColumnsOfTheSamples) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "run").string();
  const std::string line =
      "--set beam.modes=1 --set 'probe.3={position=0.3}' " + scene("16_strain_gauge.toml");
  const Finished run =
      run_graze("simulate --json --periods 1 --record samples --out " + folder + " " + line);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["units"]["probe_1"], "");
  EXPECT_EQ(document["units"]["probe_2"], "m/s");
  EXPECT_EQ(document["units"]["probe_3"], "m");
  const std::vector<std::string> samples = lines_of(folder + "/samples.csv");
  EXPECT_EQ(samples[0], "time,q1,qdot1,gap1,force1,probe_1,probe_2,probe_3");
  std::vector<double> row;
  std::istringstream cells(samples[50]);
  for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
  ASSERT_EQ(row.size(), 8U);
  // The stop is at the tip below it: gap = 1.05e-3 + u.
  EXPECT_NEAR(row[7], row[3] - 1.05e-3, 1e-15);
  // The first mode's strain near the clamp over its tip displacement, -h/2 phi''(x)/phi(L), with
  // the textbook's b and s.
  const double b = 1.8751040687119612, s = 0.7340955137589128, z = b * 0.02 / 0.3;
  const double curvature =
      b * b / 0.09 * (std::cosh(z) + std::cos(z) - s * (std::sinh(z) + std::sin(z))) / 2.0;
  EXPECT_NEAR(row[5] / row[7], -0.5 * 4.859e-4 * curvature, 1e-9);
  const json check = json::parse(run_graze("check --json " + line).out);
  ASSERT_EQ(check["probes"].size(), 3U);
  EXPECT_EQ(check["probes"][0]["quantity"], "strain");
  EXPECT_EQ(check["probes"][1]["position"], 0.15);
  EXPECT_EQ(check["probes"][2]["unit"], "m");
  EXPECT_TRUE(check["hub"].is_null());
  const std::string text = run_graze("check " + line).out;
  EXPECT_NE(text.find("  probe 1      strain at x = 0.02 m\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  probe 2      velocity (m/s) at x = 0.15 m\n"), std::string::npos) << text;
}

TEST(Simulate, BudgetsEndWithTheirOutcome) {
  const json impacts = simulated("--max-impacts 5 " + kOneMode, 3);
  EXPECT_EQ(impacts["outcome"], "event_budget");
  EXPECT_EQ(impacts["totals"]["impacts"], 5);
  EXPECT_EQ(impacts["events"].size(), 5U);
  const json seconds =
      simulated("--periods 1000000000 --max-seconds 0.2 --record none " + kOneMode, 3);
  EXPECT_EQ(seconds["outcome"], "time_budget");
}

TEST(Simulate, RefusesMotionOnAStopThatGrowsWithoutBound) {
  // Held at its tip by the oblique law of these points, the beam is unstable.
  const std::string line =
      "--set 'beam.points=[0.15,0.2,0.25,0.3]' --set stop.gap=-1e-4 " + scene("01_wagg_2004.toml");
  const json document = simulated(line, 3);
  EXPECT_EQ(document["outcome"], "refused");
  EXPECT_NE(document["message"].get<std::string>().find("stop 1"), std::string::npos);
  const Finished check = run_graze("check " + line);
  EXPECT_EQ(check.code, 0);
  EXPECT_NE(check.err.find("motion held by stop 1 cannot be followed"), std::string::npos);
  EXPECT_EQ(run_graze("check " + kMomentum).err, "");
}

TEST(Simulate, CheckSaysWhatIsNewInTheScene) {
  const json ball = json::parse(run_graze("check --json " + kBall).out);
  EXPECT_EQ(ball["gravity"], 9.81);
  EXPECT_EQ(ball["modes"][0]["load"], 9.81);
  EXPECT_NEAR(ball["closure_speed"].get<double>(), 1e-6 * std::sqrt(2.0 * 9.81), 1e-18);
  const json one = json::parse(run_graze("check --json " + kOneMode).out);
  EXPECT_TRUE(one["gravity"].is_null());
  EXPECT_TRUE(one["modes"][0]["load"].is_null());
  EXPECT_NE(run_graze("check " + kBall).out.find("gravity      9.81 m/s^2"), std::string::npos);
  EXPECT_NE(run_graze("check --set 'stop.restitution=[0.9,0.5,-2]' " + kOneMode)
                .out.find("restitution 0.9 - 0.5 v + 2 v^2"),
            std::string::npos);
  EXPECT_NE(run_graze("check " + scene("07_two_stops.toml")).out.find("stop 2: effective mass"),
            std::string::npos);
}

}  // namespace
}  // namespace graze
