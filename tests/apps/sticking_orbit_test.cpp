// `graze orbit` on a motion that sticks: document, table, CSV and options.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace graze {
namespace {

using nlohmann::json;

TEST(StickingOrbitCommand, ReportsItsStuckPhases) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "out").string();
  const Finished run = run_graze("orbit --json --out " + folder + " " + kForcedChatter);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "found");
  ASSERT_EQ(document["orbits"].size(), 1U);
  const json& orbit = document["orbits"][0];
  EXPECT_EQ(orbit["stuck"], true);
  EXPECT_EQ(orbit["stable"], true);
  EXPECT_EQ(orbit["admissible"], true);
  EXPECT_EQ(orbit["multipliers"], json::parse("[[0.0, 0.0], [0.0, 0.0]]"));
  EXPECT_EQ(orbit["impacts"].get<std::size_t>(), orbit["at"].size());
  ASSERT_EQ(orbit["stuck_phases"].size(), 1U);
  const json& stuck = orbit["stuck_phases"][0];
  EXPECT_EQ(stuck["stop"], 1);
  // Released where cos(phase) = 0.2; accumulation at 11.843334547756168 s of W = 0.5.
  EXPECT_NEAR(stuck["to"]["phase"].get<double>(), std::acos(0.2), 1e-10);
  EXPECT_NEAR(stuck["from"]["phase"].get<double>(), 0.5 * 11.843334547756168, 1e-9);
  EXPECT_NEAR(stuck["force"].get<double>(), std::cos(0.5 * 11.843334547756168) - 0.2, 1e-9);
  EXPECT_TRUE(stuck["smallest_force"].is_null());
  EXPECT_EQ(orbit["section"]["q"], json::parse("[0.2]"));
  EXPECT_EQ(orbit["section"]["qdot"], json::parse("[0.0]"));
  EXPECT_EQ(orbit["closure_speed"], document["graze"]["options"]["closure_speed"]);
  const std::vector<std::string> rows = lines_of(scratch / "out/stuck.csv");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0],
            "orbit,stop,from_period_index,from_phase,to_period_index,to_phase,duration,force,"
            "smallest_force");
  EXPECT_EQ(rows[1].substr(0, 4), "1,1,");
  const std::vector<std::string> impacts = lines_of(scratch / "out/orbits.csv");
  ASSERT_EQ(impacts.size(), 1U + orbit["at"].size());
  // Behind it `lasts`, empty with a forcing.
  EXPECT_EQ(impacts[1].substr(impacts[1].size() - 3), ",1,");
}

TEST(StickingOrbitCommand, FollowsAChatterToTheClosureSpeed) {
  std::size_t impacts = 0;
  for (const char* speed : {"1e-2", "1e-4", "1e-8"}) {
    const Finished run =
        run_graze("orbit --json --closure-speed " + std::string(speed) + " " + kForcedChatter);
    ASSERT_EQ(run.code, 0) << run.err;
    const json document = json::parse(run.out);
    ASSERT_EQ(document["orbits"].size(), 1U);
    EXPECT_EQ(document["orbits"][0]["closure_speed"].get<double>(), std::stod(speed));
    EXPECT_GT(document["orbits"][0]["at"].size(), impacts);
    impacts = document["orbits"][0]["at"].size();
  }
  EXPECT_EQ(run_graze("orbit --closure-speed -1 " + kForcedChatter).code, 2);
}

TEST(StickingOrbitCommand, PrintsATableOfStuckPhases) {
  const Finished run = run_graze("orbit --wide " + kForcedChatter);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("stuck on stop"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("1.369438406005"), std::string::npos) << run.out;  // acos 0.2
  EXPECT_NE(run.out.find("orbit that sticks"), std::string::npos) << run.out;
}

TEST(StickingOrbitCommand, IsNotListedWhereAnotherNumberOfImpactsIsAsked) {
  const Finished run = run_graze("orbit --json --impacts 1 " + kForcedChatter);
  const json result = json::parse(run.out);
  for (const json& orbit : result["orbits"]) EXPECT_EQ(orbit["stuck"], false);
}

}  // namespace
}  // namespace graze
