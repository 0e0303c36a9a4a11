// Levels and starts of continue where several things meet.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.hpp"

namespace graze {
namespace {

using nlohmann::json;

const std::string kBeam =
    "continue " + kOneMode + " --parameter forcing.frequency --from 15 --to 120";
const std::string kElastic = "continue " + scene("../validation/nlvib_oscillator.toml") +
                             " --parameter forcing.frequency --from 0.5 --to 1.5";

json told(const std::string& command) {
  const Finished run = run_graze(command + " --json");
  EXPECT_EQ(run.code, 0) << command << "\n" << run.out << run.err;
  return json::parse(run.out);
}

std::vector<json> special_in(const json& document, const std::string& label) {
  std::vector<json> found;
  for (const json& branch : document["branches"])
    for (const json& special : branch["special"])
      if (special["label"] == label) found.push_back(special);
  return found;
}

// The step that passes the level passes the doubling, too; that lies on one side of it alone.
TEST(LevelsOfContinue, EndBranchesBeforeWhatLiesBeyond) {
  const json document = told(kBeam + " --level speed=0.0094 --level-ends");
  EXPECT_EQ(special_in(document, "PD").size(), 2u);
  for (const json& branch : document["branches"])
    for (const json& special : branch["special"]) {
      EXPECT_GE(special["value"], branch["points"].front()["value"]);
      EXPECT_LE(special["value"], branch["points"].back()["value"]);
    }
}

TEST(LevelsOfContinue, EndBranchesAtTheFirstOfSeveral) {
  const json document = told(kBeam + " --level speed=0.1,speed=0.0999,speed=0.1001 --level-ends");
  const std::vector<json> marks = special_in(document, "UZ");
  ASSERT_EQ(marks.size(), 12u);  // both ends of each piece, on the way up and on the way down
  EXPECT_EQ(marks[0]["level"], "speed=0.0999");
  EXPECT_EQ(marks[2]["level"], "speed=0.1");
  EXPECT_EQ(marks[4]["level"], "speed=0.1001");
}

TEST(LevelsOfContinue, AreNoneOfConstants) {
  const json document = told("continue " + scene("32_ball_on_table.toml") +
                             " --parameter stop.motion.amplitude --from 0.0025 --to 0.005 "
                             "--impacts 1 --extreme speed,impact-rate,period");
  EXPECT_TRUE(special_in(document, "EX").empty());
}

TEST(LevelsOfContinue, LeaveGrazingsTheirName) {
  const json document = told(kElastic + " --impacts 0 --level clearance=0,stop.1.max=0.1");
  EXPECT_EQ(special_in(document, "GR").size(), 2u);
  EXPECT_TRUE(special_in(document, "UZ").empty());
}

TEST(LevelsOfContinue, AreTheSameAfterARestart) {
  ScratchFolder scratch;
  const std::string folder = scratch / "loci",
                    plane = " --locus UZ --second stop.gap --second-from 1e-3 --second-to 1e-2 ";
  told(kBeam + plane + "--level speed=0.12 --slices 2 --out " + folder);
  const std::string again = kBeam + plane + "--restart " + folder + " --label LPUZ-1 ";
  const json document = told(again + "--level speed=0.05,speed=0.12");
  ASSERT_EQ(document["loci"].size(), 1u);
  EXPECT_EQ(document["loci"][0]["level"], "speed=0.12");
  const Finished other = run_graze(again + "--level speed=0.05");
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.err.find("--level speed=0.12"), std::string::npos) << other.err;
}

TEST(StartsOfContinue, AreAlsoThoseOfTwoPeriods) {
  ScratchFolder scratch;
  const std::string spring = "continue " + scene("12_spring_dashpot_oscillator.toml") +
                             " --parameter forcing.frequency --from 1.6 --to 4",
                    folder = scratch / "doubled";
  const json all = told(spring + " --follow all --out " + folder);
  std::size_t row = 0;
  for (const json& branch : all["branches"]) {
    if (branch["period"] == 2) break;
    row += branch["points"].size();
  }
  const json doubled =
      told(spring + " --from-orbit " + folder + " --orbit " + std::to_string(row + 5));
  ASSERT_EQ(doubled["branches"].size(), 1u);
  EXPECT_EQ(doubled["branches"][0]["period"], 2);
}

TEST(StartsOfContinue, AreAlsoThoseThatMeetNoStop) {
  ScratchFolder scratch;
  const std::string orbits = scratch / "orbits", run = scratch / "run";
  told(kElastic + " --impacts 0 --out " + orbits);
  ASSERT_EQ(run_graze("simulate " + scene("../validation/nlvib_oscillator.toml") +
                      " --set forcing.frequency=0.6 --periods 400 --out " + run)
                .code,
            0);
  for (const std::string& start :
       {"--from-orbit " + orbits, "--set forcing.frequency=0.6 --from-state " + run}) {
    const json document = told(kElastic + " " + start);
    ASSERT_EQ(document["branches"].size(), 2u);
    EXPECT_EQ(document["branches"][0]["impacts"], 0);
  }
}

TEST(StartsOfContinue, LieInTheRange) {
  ScratchFolder scratch;
  const std::string run = scratch / "run";
  ASSERT_EQ(run_graze("simulate " + kOneMode + " --periods 200 --out " + run).code, 0);
  const Finished outside = run_graze("continue " + kOneMode +
                                     " --parameter forcing.frequency --from 15 --to 20 "
                                     "--from-state " +
                                     run);
  EXPECT_EQ(outside.code, 2);
  EXPECT_NE(outside.err.find("which the range from 15 to 20 does not hold"), std::string::npos)
      << outside.err;
}

}  // namespace
}  // namespace graze
