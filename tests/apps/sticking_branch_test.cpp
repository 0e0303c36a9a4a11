// `graze continue` and `graze diagram` on a motion that sticks: documents, tables, CSV, pictures.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace graze {
namespace {

using nlohmann::json;

constexpr double kHalfTurn = 3.14159265358979324;
const std::string kRestitutionRange = " --parameter stop.restitution --from 0.1 --to 0.6 ";

TEST(StickingBranchCommand, ReportsTheBranchAndItsChatterPoint) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "out").string();
  const Finished run =
      run_graze("continue --json" + kRestitutionRange + "--out " + folder + " " + kForcedChatter);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "complete");
  ASSERT_EQ(document["branches"].size(), 1U);
  const json& branch = document["branches"][0];
  EXPECT_EQ(branch["stuck"], true);
  EXPECT_TRUE(branch["impacts"].is_null());
  EXPECT_EQ(branch["stops"], json::parse("[1]"));
  EXPECT_EQ(branch["ends"], json::parse(R"(["parameter limit", "CH"])"));
  ASSERT_EQ(branch["special"].size(), 1U);
  const json& special = branch["special"][0];
  EXPECT_EQ(special["id"], "CH1");
  EXPECT_EQ(special["label"], "CH");
  EXPECT_EQ(special["chatter"], "completes at its release");
  // tests/reference/chatter_points.csv, Z2b_r
  EXPECT_NEAR(special["value"].get<double>(), 0.5134941368753766, 1e-10 * 0.5);
  EXPECT_EQ(branch["points"].back()["value"], special["value"]);
  ASSERT_GE(branch["points"].size(), 10U);
  for (const json& point : branch["points"]) {
    EXPECT_EQ(point["stuck"], true);
    EXPECT_EQ(point["admissible"], true);
    EXPECT_EQ(point["stable"], true);
    EXPECT_EQ(point["multipliers"], json::parse("[[0.0, 0.0], [0.0, 0.0]]"));
    EXPECT_EQ(point["impacts"].get<std::size_t>(), point["at"].size());
    ASSERT_EQ(point["stuck_phases"].size(), 1U);
    EXPECT_NEAR(point["stuck_phases"][0]["to"]["phase"].get<double>(), std::acos(0.2), 1e-10);
  }
  const std::vector<std::string> rows = lines_of(scratch / "out/branches.csv");
  ASSERT_EQ(rows.size(), 1U + branch["points"].size());
  EXPECT_EQ(rows[0].substr(rows[0].size() - 6), ",stuck");
  EXPECT_EQ(rows[1].substr(rows[1].size() - 2), ",1");
  EXPECT_EQ(lines_of(scratch / "out/special.csv").size(), 2U);
}

TEST(StickingBranchCommand, IsNotTracedWhereANumberOfImpactsIsAsked) {
  const Finished run =
      run_graze("continue --json --impacts 1" + kRestitutionRange + kForcedChatter);
  const json result = json::parse(run.out);
  for (const json& branch : result["branches"]) EXPECT_EQ(branch["stuck"], false);
}

TEST(StickingBranchCommand, SumsChattersBelowTheClosureSpeed) {
  for (const char* speed : {"1e-3", "1e-6"}) {
    const Finished run = run_graze("continue --json --closure-speed " + std::string(speed) +
                                   kRestitutionRange + kForcedChatter);
    ASSERT_EQ(run.code, 0) << run.err;
    const json branch = json::parse(run.out)["branches"][0];
    EXPECT_EQ(branch["points"][0]["closure_speed"].get<double>(), std::stod(speed));
    EXPECT_NEAR(branch["special"][0]["value"].get<double>(), 0.5134941368753766, 1e-10 * 0.5);
  }
}

TEST(StickingBranchCommand, PrintsTheBranch) {
  const Finished run = run_graze("continue" + kRestitutionRange + kForcedChatter);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("(1, stick)"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("CH1"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("0.51349413687"), std::string::npos) << run.out;
}

TEST(StickingBranchCommand, IsDrawnInBothPictures) {
  const ScratchFolder scratch;
  const std::string branches = (scratch / "branches.svg").string();
  ASSERT_EQ(run_graze("continue --plot " + branches + kRestitutionRange + kForcedChatter).code, 0);
  EXPECT_NE(read_text(branches).find("chatter ends (CH)"), std::string::npos);
  for (const char* section : {"impact", "stroboscopic"}) {
    const std::string diagram = (scratch / (std::string(section) + ".svg")).string();
    const Finished run =
        run_graze("diagram --points 21 --periods 50 --section " + std::string(section) +
                  " --plot " + diagram + kRestitutionRange + kForcedChatter);
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(read_text(diagram).find("chatter ends (CH)"), std::string::npos);
  }
}

// Held at the gap a the oscillator is pressed on its stop with F cos(theta) - a. Where F = -a that
// falls to nothing once a period, at theta = pi; beyond, it is never let go.
TEST(StickingBranchCommand, EndsWhereTheStructureIsNotLeftAnyMore) {
  struct Case {
    const char* range;
    double value;
  };
  for (const Case& expected : {Case{"stop.gap --from -0.4 --to 0.1", -0.3},
                               Case{"forcing.amplitude --from 0.1 --to 0.5", 0.2}}) {
    SCOPED_TRACE(expected.range);
    const std::string line =
        "continue " + scene("08_preloaded_oscillator.toml") + " --parameter " + expected.range;
    const Finished run = run_graze(line + " --json");
    EXPECT_EQ(run.code, 0) << run.err;
    const json document = json::parse(run.out);
    ASSERT_EQ(document["branches"].size(), 1U);
    const json& branch = document["branches"][0];
    EXPECT_EQ(branch["ends"], json::parse(R"(["at rest", "parameter limit"])"));
    ASSERT_EQ(branch["special"].size(), 1U);
    const json& special = branch["special"][0];
    EXPECT_EQ(special["id"], "LO1");
    EXPECT_EQ(special["label"], "LO");
    EXPECT_NEAR(special["value"].get<double>(), expected.value, 1e-12);
    EXPECT_NEAR(special["phase"].get<double>(), kHalfTurn, 1e-9);
    EXPECT_EQ(special["speed"], 0.0);
    const std::string table = run_graze(line).out;
    EXPECT_NE(table.find("at rest at"), std::string::npos) << table;
    EXPECT_NE(table.find("LO1"), std::string::npos) << table;
  }
}

// An orbit of four periods that sticks once in them. Runs of 2,000 periods repeat with four of them
// between these values and with others outside: at either end the chatter completes no more.
TEST(StickingBranchCommand, OfFourPeriodsEndsWhereItsChatterCompletesNoMore) {
  const Finished run =
      run_graze("diagram --json --points 20 --from 2.885 --to 2.8945 --parameter " +
                ("forcing.frequency " + kOscillator));
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  std::vector<json> found;
  for (const json& branch : document["branches"])
    if (branch["period"] == 4) found.push_back(branch);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0]["ends"], json::array({"CH", "CH"}));
  const json& points = found[0]["points"];
  EXPECT_GT(points.front()["value"].get<double>(), 2.8875292);
  EXPECT_LT(points.front()["value"].get<double>(), 2.8875294);
  EXPECT_GT(points.back()["value"].get<double>(), 2.8925414);
  EXPECT_LT(points.back()["value"].get<double>(), 2.8925416);
}

// A stop without a shape is none: the branch goes up to it from either side.
TEST(StickingBranchCommand, SurvivesAValueThatTheSceneDoesNotAllow) {
  const Finished run = run_graze("continue " + scene("04_impact_oscillator.toml") +
                                 " --json --parameter stop.shape.1 --from -1 --to 1");
  EXPECT_TRUE(run.code == 0 || run.code == 3) << run.code << run.err;
  EXPECT_TRUE(nlohmann::json::accept(run.out));
}

}  // namespace
}  // namespace graze
