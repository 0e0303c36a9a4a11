// graze cost and the flows that take steps, as a user meets them.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace graze {
namespace {

using nlohmann::json;

TEST(CostCommand, WritesTheDocument) {
  const ScratchFolder scratch;
  const Finished run = run_graze("cost --json --impacts 5 --out " + (scratch / "run").string() +
                                 " --plot " + (scratch / "cost.svg").string() + " " + kOneMode);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "measured");
  EXPECT_EQ(document["reference"], "exact, 50 digits");
  EXPECT_EQ(document["span"].get<std::string>().substr(0, 15), "first 5 impacts");
  EXPECT_EQ(document["units"]["error"], "s");
  const json& rows = document["rows"];
  ASSERT_GE(rows.size(), 10u);
  EXPECT_EQ(rows[0]["flow"], "exact");
  EXPECT_EQ(rows[0]["setting"], "");
  EXPECT_LE(rows[0]["error"].get<double>(), 1e-12);
  for (const json& row : rows) {
    EXPECT_GT(row["seconds_per_period"].get<double>(), 0.0);
    EXPECT_GT(row["evaluations_per_period"].get<double>(), 0.0);
    EXPECT_EQ(row["impacts_agree"].get<bool>(), !row["error"].is_null());
  }
  EXPECT_EQ(document["recommended"]["tolerance"], 1e-10);
  EXPECT_TRUE(document["recommended"]["flow"].is_string());
  EXPECT_TRUE(std::filesystem::exists(scratch / "run" / "costs.csv"));
  EXPECT_TRUE(std::filesystem::exists(scratch / "cost.svg"));
}

// A chattering beam whose number of modes is free.
TEST(CostCommand, TellsTheCostsOfModesOfClosureAndOfNewtonsSteps) {
  const ScratchFolder scratch;
  const std::string beam = scene("02_wagg_momentum.toml");
  const Finished run =
      run_graze("cost --json --impacts 3 --out " + (scratch / "run").string() + " " + beam);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  const auto lines = [&](const char* file) {
    std::ifstream table(scratch / "run" / file);
    return std::count(std::istreambuf_iterator<char>(table), {}, '\n');
  };

  const json& modes = document["modes"];
  ASSERT_GE(modes.size(), 8u);
  EXPECT_EQ(lines("costs_of_modes.csv"), static_cast<long>(modes.size()) + 1);
  EXPECT_EQ(modes.front()["modes"], 1);
  EXPECT_GT(modes.front()["error"].get<double>(), 10.0 * modes.back()["error"].get<double>());
  for (const json& row : modes) EXPECT_GT(row["seconds_per_period"].get<double>(), 0.0);

  const json& closure = document["closure"];
  ASSERT_GE(closure.size(), 4u);
  EXPECT_EQ(lines("costs_of_closure.csv"), static_cast<long>(closure.size()) + 1);
  for (std::size_t i = 1; i < closure.size(); ++i) {
    EXPECT_LT(closure[i]["closure_speed"], closure[i - 1]["closure_speed"]);
    EXPECT_GE(closure[i]["impacts_per_period"], closure[i - 1]["impacts_per_period"]);
  }

  const json& corrector = document["corrector"];
  EXPECT_EQ(corrector["orbit"].is_null(), corrector["rows"].empty());
  EXPECT_EQ(corrector["orbit"].is_null(), corrector.contains("message"));
  EXPECT_EQ(lines("costs_of_corrector.csv"), static_cast<long>(corrector["rows"].size()) + 1);
}

TEST(CostCommand, PutsEachOfItsTablesUnderAHeading) {
  const Finished run = run_graze("cost --impacts 3 " + scene("02_wagg_momentum.toml"));
  ASSERT_EQ(run.code, 0) << run.err;
  std::size_t place = 0;
  for (const char* heading :
       {"flow ", "\nModes, against 64 of them\n", "\nClosure speed, ", "\nNewton's steps"}) {
    place = run.out.find(heading, place);
    ASSERT_NE(place, std::string::npos) << heading << " in\n" << run.out;
  }
}

// The tangent of a branch predicts its orbit to the second order of the distance.
TEST(CostCommand, ShowsNewtonsStepsConverging) {
  const Finished run = run_graze("cost --json --impacts 5 " + kOneMode);
  ASSERT_EQ(run.code, 0) << run.err;
  const json corrector = json::parse(run.out)["corrector"];
  ASSERT_EQ(corrector["orbit"], "orbit (1, 1)") << corrector.dump();
  int predicted = 0;
  double first = 0.0, first_predicted = 0.0;
  for (const json& row : corrector["rows"]) {
    if (row["steps"] != 0) continue;
    (row["predicted"] ? first_predicted : first) = row["error"];
    ++predicted;
  }
  EXPECT_EQ(predicted, 2);
  // The distance is 1e-3.
  EXPECT_LT(first_predicted, 0.1 * first);
  EXPECT_GT(first_predicted, 0.0);
}

TEST(CostCommand, NamesTheSpanWithoutImpacts) {
  const Finished run = run_graze("cost --wide --duration 1 --set stop.gap=1 " + kOneMode);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("error / amplitude"), std::string::npos);
  EXPECT_NE(run.out.find("no impacts, 1 s"), std::string::npos) << run.out;
}

TEST(CostCommand, SaysWhenTheImpactsAreSpent) {
  const Finished run = run_graze("cost --json --max-impacts 3 " + kOneMode);
  EXPECT_EQ(run.code, 3);
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "budget");
  EXPECT_FALSE(document["message"].get<std::string>().empty());
  EXPECT_TRUE(document["recommended"]["flow"].is_null());
}

// Without forcing costs are per second of motion.
TEST(CostCommand, NamesWhatItsTimesArePer) {
  const Finished ball = run_graze("cost --wide " + scene("06_bouncing_ball.toml"));
  ASSERT_EQ(ball.code, 0) << ball.err;
  EXPECT_NE(ball.out.find("time / s "), std::string::npos) << ball.out;
  EXPECT_EQ(ball.out.find("period"), std::string::npos) << ball.out;
}

// A span shorter than the samples' usual distance still compares.
TEST(CostCommand, ComparesAShortSpan) {
  const Finished run = run_graze("cost --json --duration 1e-3 " + kOneMode);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  for (const json& row : document["rows"]) EXPECT_FALSE(row["error"].is_null());
}

TEST(CostCommand, SaysWhenTheTimeIsSpent) {
  const Finished run = run_graze("cost --json --max-seconds 0.05 " + kOneMode);
  EXPECT_EQ(run.code, 3);
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "budget");
  EXPECT_FALSE(document["message"].get<std::string>().empty());
}

// At a compliant stop: contacts are compared, and the order across one of them is told.
TEST(CostCommand, ComparesContactsWithACompliantStop) {
  const ScratchFolder scratch;
  const std::string options = " --duration 0.02 --out " + (scratch / "run").string() + " --plot " +
                              (scratch / "cost.svg").string() + " ";
  const Finished run = run_graze("cost --json" + options + scene("11_body_meets_stop.toml"));
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["reference"],
            "exact, 50 digits; contacts with compliant stops integrated to 1e-24 a step");
  EXPECT_EQ(document["span"], "first 1 contact, 0.02 s");
  // 3.3e-4 s after the first instant comes the second; a rounding of either is 2e-18 s.
  EXPECT_EQ(document["rows"][0]["flow"], "exact");
  EXPECT_LE(document["rows"][0]["error"].get<double>(), 1e-14);
  EXPECT_TRUE(document["closure"].empty());
  EXPECT_EQ(document["closure_message"], "not measured where a stop is compliant");
  const json& contact = document["contact"];
  EXPECT_EQ(contact["stop"], 1);
  EXPECT_NEAR(contact["mass"].get<double>(), 0.1, 1e-15);
  EXPECT_NEAR(contact["speed"].get<double>(), 0.1, 1e-15);
  EXPECT_NEAR(contact["depth"].get<double>(), 1.11664597110381e-5, 1e-17);
  std::size_t rows = 0;
  for (const json& line : contact["lines"]) {
    rows += line["rows"].size();
    const bool linear = line["spring"] == "linear";
    if (line["method"] == "exact") {
      EXPECT_TRUE(line["order"].is_null());
    } else {
      EXPECT_NEAR(line["order"].get<double>(),
                  !linear                            ? 2.5
                  : line["method"] == "rk4, located" ? 4.0
                                                     : 2.0,
                  0.2);
    }
  }
  EXPECT_EQ(contact["lines"].size(), 6u);
  std::ifstream table(scratch / "run" / "costs_of_contact.csv");
  std::string header;
  std::getline(table, header);
  EXPECT_EQ(header, "spring,method,order,steps,step,error,seconds,evaluations");
  EXPECT_EQ(std::count(std::istreambuf_iterator<char>(table), {}, '\n'), static_cast<long>(rows));
  std::ifstream picture(scratch / "cost.svg");
  const std::string drawn((std::istreambuf_iterator<char>(picture)), {});
  for (const char* text :
       {"step / duration<", "computing time<", "of the contact (", "linear, not located: order"})
    EXPECT_NE(drawn.find(text), std::string::npos) << text;
}

TEST(CostCommand, PrintsTheOrderAcrossAContact) {
  const Finished run = run_graze("cost --wide --duration 0.02 " + scene("11_body_meets_stop.toml"));
  ASSERT_EQ(run.code, 0) << run.err;
  for (const char* text : {"error of contacts (s)", "same contacts",
                           "Order of rk4 across one contact: 0.1 kg at 0.1 m/s",
                           "Hertz, not located", "\n            order ", "\n       exact flow "})
    EXPECT_NE(run.out.find(text), std::string::npos) << text << " in\n" << run.out;
  const Finished away =
      run_graze("cost --wide --duration 0.005 " + scene("11_body_meets_stop.toml"));
  EXPECT_NE(away.out.find("Order across a contact: no contact with a compliant stop begins"),
            std::string::npos)
      << away.out;
}

// The table is absent where it would say nothing.
TEST(CostCommand, RigidStopsHaveNoOrderAcrossAContact) {
  const Finished run = run_graze("cost --json --impacts 3 " + kOneMode);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_FALSE(json::parse(run.out).contains("contact"));
}

TEST(StepFlows, AreSaidByCheckAndUsedBySimulate) {
  const std::string stepping = " --set solver.flow=\\\"rk4\\\" --set solver.step=1e-4 ";
  const Finished check = run_graze("check --json" + stepping + kOneMode);
  ASSERT_EQ(check.code, 0) << check.err;
  const json checked = json::parse(check.out);
  EXPECT_EQ(checked["flow"], "rk4");
  EXPECT_EQ(checked["step"], 1e-4);
  const double omega = checked["modes"][0]["frequency"].get<double>();
  EXPECT_NEAR(checked["longest_stable_step"].get<double>(), 2.8284271247461903 / omega, 1e-12);
  const Finished stepped = run_graze("simulate --json --periods 3" + stepping + kOneMode);
  const Finished exact = run_graze("simulate --json --periods 3 " + kOneMode);
  ASSERT_EQ(stepped.code, 0) << stepped.err;
  const json a = json::parse(stepped.out), b = json::parse(exact.out);
  ASSERT_EQ(a["events"].size(), b["events"].size());
  ASSERT_FALSE(b["events"].empty());
  for (std::size_t i = 0; i < b["events"].size(); ++i) {
    const double off = a["events"][i]["time"].get<double>() - b["events"][i]["time"].get<double>();
    EXPECT_NE(off, 0.0);
    EXPECT_NEAR(off, 0.0, 1e-7);
  }
}

TEST(StepFlows, AreRefusedWhereTheyCannotServe) {
  const Finished orbit = run_graze("orbit --set solver.flow=\\\"dopri5\\\" " + kOneMode);
  EXPECT_EQ(orbit.code, 2);
  EXPECT_NE(orbit.err.find("solver.flow"), std::string::npos) << orbit.err;
  const Finished unstable =
      run_graze("simulate --set solver.flow=\\\"rk4\\\" --set solver.step=1 " + kOneMode);
  EXPECT_EQ(unstable.code, 2);
  EXPECT_NE(unstable.err.find("it must be at most"), std::string::npos) << unstable.err;
}

}  // namespace
}  // namespace graze
