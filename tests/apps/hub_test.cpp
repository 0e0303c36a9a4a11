// Beams on a hub as a user meets them.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.hpp"

namespace graze {
namespace {

using nlohmann::json;

const std::string kScenes = std::string(GRAZE_SOURCE_DIR) + "/data/scenes/";
const std::string kFirst = kScenes + "17_yigit_lee_wang_1.toml";
const std::string kMomentum = kScenes + "19_yigit_momentum.toml";
const std::string kSensitivity = kScenes + "20_yigit_sensitivity.toml";

// No impact for the first 0.1 s: the torque turns hub and beam.
TEST(HubCommand, FinalHoldsAngleAndRate) {
  const Finished run = run_graze(
      "simulate --json --duration 0.1 --set beam.area=2.4e-4 --set beam.density=2710 "
      "--set hub.inertia=5e-3 --set hub.torque.amplitude=0.24 " +
      kFirst);
  ASSERT_EQ(run.code, 0) << run.err;
  const json final = json::parse(run.out)["final"];
  EXPECT_EQ(final["q"].size(), 3u);
  EXPECT_EQ(final["qdot"].size(), 3u);
  EXPECT_GT(final["rate"].get<double>(), 0.0);
  const double mass = 2710.0 * 2.4e-4,
               inertia = 5e-3 + mass * 0.57 * 0.57 * 0.57 / 3.0 - mass * 0.02 * 0.02 * 0.02 / 3.0;
  // theta = T t^2/(2 J), but for what the beam bends.
  EXPECT_NEAR(final["angle"].get<double>() / (0.5 * 0.24 * 0.01 / inertia), 1.0, 0.05);
}

TEST(HubCommand, SamplesHaveTheHubsColumns) {
  const ScratchFolder out;
  const Finished run =
      run_graze("simulate --duration 0.01 --record samples --sample-rate 1000 --out " +
                (out / "run").string() + " " + kFirst);
  ASSERT_EQ(run.code, 0) << run.err;
  std::ifstream table(out / "run" / "samples.csv");
  std::string header;
  std::getline(table, header);
  EXPECT_EQ(header,
            "time,angle,rate,q1,q2,q3,qdot1,qdot2,qdot3,gap1,force1,probe_1,probe_2,probe_3");
}

TEST(HubCommand, GoesOnWhereItEnded) {
  const ScratchFolder out;
  const std::string folder = (out / "run").string();
  const std::string friction = " --set \"hub.friction={coulomb=0.01}\" ";
  ASSERT_EQ(run_graze("simulate --duration 0.3485 --out " + folder + friction + kMomentum).code, 0);
  const Finished rest =
      run_graze("simulate --json --duration 0.7 --resume " + folder + friction + kMomentum);
  ASSERT_EQ(rest.code, 0) << rest.err;
  const Finished whole = run_graze("simulate --json --duration 0.7 " + friction + kMomentum);
  EXPECT_EQ(json::parse(rest.out)["final"], json::parse(whole.out)["final"]);
}

TEST(HubCommand, WhatNeedsAPeriodSaysSo) {
  for (const std::string& line :
       {"orbit " + kFirst, "continue --parameter stop.gap --from 0.1 --to 0.2 " + kFirst}) {
    const Finished run = run_graze(line);
    EXPECT_EQ(run.code, 2) << line;
    EXPECT_NE(run.err.find("under a forcing that repeats itself; a structure on a hub has none"),
              std::string::npos)
        << run.err;
    EXPECT_EQ(run.out, "");
  }
}

TEST(HubCommand, SensitivitiesOverTheDamping) {
  const std::string line =
      "compare --json --sensitivity --duration 0.15 --parameter stop.spring.damping.coefficient "
      "--from 100 --to 1000 --points 4 --reference 500 --second hub.inertia --second-values "
      "4.992e-3,2e-2 " +
      kSensitivity;
  const Finished run = run_graze(line);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "compared");
  ASSERT_EQ(document["curves"].size(), 2u);
  for (const json& curve : document["curves"]) {
    // s1 adds up to nothing, and s2 is what it says.
    double sum = 0.0;
    for (const json& point : curve["points"]) {
      sum += point["s1"][0].get<double>();
      EXPECT_NEAR(
          point["s2"][1].get<double>(),
          1.0 - point["ends"][1].get<double>() / curve["reference"]["ends"][1].get<double>(),
          1e-12);
      EXPECT_GE(point["impacts"].size(), 1u);
    }
    EXPECT_NEAR(sum, 0.0, 1e-12);
  }
  EXPECT_EQ(run_graze(line + " --threads 1").out, run.out);
}

TEST(HubCommand, SensitivitiesNeedProbesAndARange) {
  const Finished none = run_graze(
      "compare --sensitivity --duration 0.1 --parameter stop.gap --from "
      "1 --to 2 " +
      kScenes + "06_bouncing_ball.toml");
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("there is no [[probe]]"), std::string::npos) << none.err;
  EXPECT_EQ(run_graze("compare --sensitivity --duration 0.1 " + kSensitivity).code, 2);
  EXPECT_EQ(
      run_graze("compare --sensitivity --parameter stop.gap --from 1 --to 2 " + kSensitivity).code,
      2);
}

}  // namespace
}  // namespace graze
