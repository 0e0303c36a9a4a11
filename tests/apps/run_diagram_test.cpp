// graze diagram of motions that no forcing repeats: one run at each value.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/program.hpp"

namespace graze {
namespace {

using nlohmann::json;

const std::string kDrops = "--parameter stop.gap --from 0.5 --to 2 ";
const std::string kHub = scene("19_yigit_momentum.toml");
const std::string kTorques = "--parameter hub.torque.amplitude --from 0.1 --to 0.2 --points 3 ";

// From a height h the first impact comes after sqrt(2 h/g) at sqrt(2 g h); every later flight lasts
// r times as long and ends r times as fast as the one before, the first of them 2 r sqrt(2 h/g).
TEST(RunDiagram, OfABallOverItsDrop) {
  const Finished run = run_graze("diagram --json --duration 1.8 --points 7 " + kDrops + kBall);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "complete");
  EXPECT_EQ(document["parameter"], "stop.gap");
  EXPECT_EQ(document["unit"], "m");
  EXPECT_EQ(document["duration"], 1.8);
  ASSERT_EQ(document["runs"].size(), 7u);
  for (int k = 0; k < 7; ++k) {
    const json& run_at = document["runs"][static_cast<std::size_t>(k)];
    const double h = 0.5 + 0.25 * k, g = 9.81, r = 0.8, fall = std::sqrt(2.0 * h / g);
    EXPECT_EQ(run_at["value"], h);
    EXPECT_EQ(run_at["reached_end"], true);
    std::size_t count = 0;
    double time = fall, flight = 2.0 * r * fall, speed = g * fall;
    for (; time < 1.8; time += flight, flight *= r, speed *= r, ++count) {
      ASSERT_LT(count, run_at["impacts"].size());
      const json& impact = run_at["impacts"][count];
      EXPECT_NEAR(impact["time"].get<double>(), time, 1e-13);
      EXPECT_NEAR(impact["speed"].get<double>(), speed, 1e-12);
      EXPECT_EQ(impact["stop"], 1);
    }
    EXPECT_EQ(run_at["impacts"].size(), count) << h;
  }
}

// A ball thrown at v towards the floor, h below, hits it at sqrt(v^2 + 2 g h) after
// (sqrt(v^2 + 2 g h) - v)/g.
TEST(RunDiagram, OfABallOverTheSpeedItIsThrownAt) {
  const Finished run = run_graze(
      "diagram --json --duration 1.2 --parameter initial.qdot.1 --from -2 --to 2 --points 5 "
      "--set stop.gap=1 " +
      scene("06_bouncing_ball.toml"));
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["unit"], "kg^1/2 m/s");
  ASSERT_EQ(document["runs"].size(), 5u);
  for (const json& one : document["runs"]) {
    const double v = one["value"], g = 9.81, h = 1.0;
    ASSERT_GE(one["impacts"].size(), 1u);
    const double speed = one["impacts"][0]["speed"];
    EXPECT_NEAR(speed, std::sqrt(v * v + 2.0 * g * h), 1e-12);
    EXPECT_NEAR(one["impacts"][0]["time"].get<double>(), (speed - v) / g, 1e-12);
  }
}

TEST(RunDiagram, OfAHubOverItsFirstRate) {
  const std::string rates = "--parameter initial.rate --from 0 --to 2 --points 3 ";
  const Finished run = run_graze("diagram --json --duration 0.3 " + rates + kHub);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["unit"], "rad/s");
  const json single =
      json::parse(run_graze("simulate --json --duration 0.3 --set initial.rate=1.0 " + kHub).out);
  std::vector<double> times, told;
  for (const json& event : single["events"])
    if (event["kind"] == "impact" || (event["kind"] == "contact" && event["speed"] > 0.0))
      times.push_back(event["time"]);
  for (const json& impact : document["runs"][1]["impacts"]) told.push_back(impact["time"]);
  EXPECT_FALSE(times.empty());
  EXPECT_EQ(told, times);
  EXPECT_EQ(run_graze("diagram --duration 1 --parameter initial.rate --from 0 --to 2 " +
                      scene("06_bouncing_ball.toml"))
                .code,
            2);
}

// A row of a diagram is the run that simulate makes.
TEST(RunDiagram, OfAHubOverItsTorque) {
  const std::string line = "diagram --json --duration 0.3 " + kTorques + kHub;
  const Finished run = run_graze(line);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["unit"], "N m");
  ASSERT_EQ(document["runs"].size(), 3u);
  EXPECT_EQ(document["probes"].size(), document["runs"][0]["peaks"].size());
  const json single = json::parse(
      run_graze("simulate --json --duration 0.3 --set hub.torque.amplitude=0.2 " + kHub).out);
  std::vector<double> times;
  for (const json& event : single["events"])
    if (event["kind"] == "impact") times.push_back(event["time"]);
  const json& last = document["runs"][2]["impacts"];
  ASSERT_EQ(last.size(), times.size());
  EXPECT_GE(times.size(), 1u);
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_EQ(last[i]["time"], times[i]);
  EXPECT_EQ(run_graze(line + " --threads 1").out, run.out);
}

TEST(RunDiagram, WritesTablesAndAPicture) {
  const ScratchFolder out;
  const std::string folder = (out / "run").string(), picture = (out / "drops.svg").string();
  const Finished run = run_graze("diagram --duration 1 --points 3 --out " + folder + " --plot " +
                                 picture + " " + kDrops + kBall);
  ASSERT_EQ(run.code, 0) << run.err;
  // The fall of 0.5 m takes 0.319 s, the first flight 0.511 s, the second 0.409 s.
  EXPECT_NE(run.out.find("3 values, 4 impacts"), std::string::npos) << run.out;
  std::istringstream impacts(read_text(out / "run" / "sweep.csv"));
  std::string line;
  std::getline(impacts, line);
  EXPECT_EQ(line, "value,impact,time,stop,speed");
  std::size_t rows = 0;
  while (std::getline(impacts, line)) ++rows;
  EXPECT_EQ(rows, 4u);
  std::istringstream runs(read_text(out / "run" / "runs.csv"));
  std::getline(runs, line);
  EXPECT_EQ(line, "value,reached_end,impacts");
  EXPECT_NE(read_text(picture).find("impact speed"), std::string::npos);
}

TEST(RunDiagram, SaysWhatIsMissing) {
  const Finished no_time = run_graze("diagram " + kDrops + kBall);
  EXPECT_EQ(no_time.code, 2);
  EXPECT_NE(no_time.err.find("--duration: it is missing; no forcing repeats"), std::string::npos)
      << no_time.err;
  EXPECT_EQ(run_graze("diagram --duration 1 --section stroboscopic " + kDrops + kBall).code, 2);
  EXPECT_EQ(run_graze("diagram --duration 1 --branches none " + kDrops + kBall).code, 2);
  const Finished forced =
      run_graze("diagram --duration 1 " + kDrops + scene("04_impact_oscillator.toml"));
  EXPECT_EQ(forced.code, 2);
  EXPECT_NE(forced.err.find("--duration: it is not allowed here"), std::string::npos) << forced.err;
  const Finished nothing = run_graze(
      "diagram --duration 1 --parameter gravity.acceleration --from 1 --to 2 "
      "--set 'stop=[]' " +
      kBall);
  EXPECT_EQ(nothing.code, 2);
}

TEST(RunDiagram, KeepsWhatWasFinishedInTime) {
  const Finished run =
      run_graze("diagram --json --duration 1 --points 3 --max-seconds 1e-9 " + kDrops + kBall);
  EXPECT_EQ(run.code, 3) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "budget");
  EXPECT_LT(document["runs"].size(), 3u);
  // A run that spends its impacts is a row, and the outcome tells of it.
  const Finished few =
      run_graze("diagram --json --duration 1 --points 3 --max-impacts 1 " + kDrops + kBall);
  EXPECT_EQ(few.code, 3);
  const json cut = json::parse(few.out);
  ASSERT_EQ(cut["runs"].size(), 3u);
  EXPECT_EQ(cut["runs"][0]["reached_end"], false);
  EXPECT_NE(cut["message"].get<std::string>().find("did not reach their end; the first, at 0.5"),
            std::string::npos);
}

}  // namespace
}  // namespace graze
