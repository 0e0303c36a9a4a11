// graze simulate --section: the Poincare section of a run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace graze {
namespace {

using nlohmann::json;

const std::string kOrbit =
    "simulate --json --set forcing.frequency=40 --periods 400 " + scene("05_wagg_one_mode.toml");

// The motion settles on the (1, 1) orbit that `graze orbit` solves for, so the end of the section
// is one point.
TEST(SectionCommand, OfAnOrbitIsItsImpacts) {
  const json orbit = json::parse(
      run_graze("orbit --json --set forcing.frequency=40 " + scene("05_wagg_one_mode.toml")).out);
  const json& at = orbit["orbits"][0];
  const ScratchFolder out;
  const Finished run = run_graze(kOrbit + " --section impact --transient 300 --out " +
                                 (out / "run").string() + " --plot " + (out / "s.svg").string());
  ASSERT_EQ(run.code, 0) << run.err;
  const json section = json::parse(run.out)["section"];
  EXPECT_EQ(section["kind"], "impact");
  ASSERT_EQ(section["points"], 100);
  EXPECT_EQ(section["left_out"], 0);
  for (std::size_t i = 0; i < 100; ++i) {
    EXPECT_NEAR(section["phase"][i].get<double>(), at["phases"][0].get<double>(), 1e-9);
    EXPECT_NEAR(section["speed"][i].get<double>(), at["speeds"][0].get<double>(), 1e-10);
  }
  const std::string table = read_text(out / "run" / "section.csv");
  EXPECT_EQ(table.rfind("time,stop,phase,speed\n", 0), 0u);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 101);
  EXPECT_NE(read_text(out / "s.svg").find("impact speed"), std::string::npos);
}

// Stroboscopic are the states at the starts of forcing periods, which samples at that rate are too.
TEST(SectionCommand, StroboscopicIsWhatSamplesAre) {
  const Finished run = run_graze(kOrbit + " --section stroboscopic --transient 0");
  ASSERT_EQ(run.code, 0) << run.err;
  const json section = json::parse(run.out)["section"];
  ASSERT_GE(section["points"], 400);
  const double period = 2.0 * M_PI / 40.0;
  for (std::size_t i = 0; i < 400; ++i)
    EXPECT_NEAR(section["time"][i].get<double>(), static_cast<double>(i) * period, 1e-9);
  EXPECT_NEAR(section["displacement"][398].get<double>(),
              section["displacement"][397].get<double>(), 1e-12);
  EXPECT_NE(section["displacement"][398], 0.0);
}

TEST(SectionCommand, TakesTheOldWordOfAStroboscopicOne) {
  const Finished run = run_graze(kOrbit + " --section strobe");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(json::parse(run.out)["section"]["kind"], "stroboscopic");
}

TEST(SectionCommand, SaysWhatItNeeds) {
  EXPECT_EQ(
      run_graze("simulate --section impact --duration 1 " + scene("06_bouncing_ball.toml")).code,
      2);
  EXPECT_EQ(run_graze(kOrbit + " --section stroboscopic --record samples").code, 2);
  EXPECT_EQ(run_graze(kOrbit + " --transient 3").code, 2);
  EXPECT_EQ(run_graze(kOrbit + " --section impact --transient 400").code, 2);
  EXPECT_EQ(run_graze(kOrbit + " --section plane").code, 2);
}

}  // namespace
}  // namespace graze
