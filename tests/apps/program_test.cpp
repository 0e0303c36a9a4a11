// The program itself: what it prints where, and how it ends.
#include "apps/program.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

namespace graze {
namespace {

using nlohmann::json;

TEST(Program, PrintsVersionAndHelpOfEveryCommand) {
  EXPECT_EQ(run_graze("--version").out, "graze 0.1.0\n");
  for (const char* command : {"", "check ", "simulate ", "orbit ", "continue ", "diagram "}) {
    const Finished help = run_graze(std::string(command) + "--help");
    EXPECT_EQ(help.code, 0);
    EXPECT_NE(help.out.find("Usage"), std::string::npos);
    EXPECT_EQ(help.err, "");
  }
}

TEST(Program, UsageErrorsExitWith2AndPrintNothingOnStdout) {
  for (const std::string& line : std::vector<std::string>{
           "", "frobnicate", "check", "check --bogus " + kOneMode,
           "simulate --periods -3 " + kOneMode, "simulate --periods 3 --duration 2 " + kOneMode,
           "orbit --period 0 " + kOneMode, "orbit --impacts nought " + kOneMode,
           "continue " + kOneMode, "continue --parameter nope --from 1 --to 2 " + kOneMode,
           "continue --parameter forcing.frequency --from 3 --to 3 " + kOneMode,
           "continue --parameter forcing.frequency --from -3 --to 3 " + kOneMode,
           "continue --parameter stop.restitution --from 0 --to 1.5 " + kOneMode,
           "check --set stop.gap " + kOneMode, "check --set stop.gapp=1 " + kOneMode,
           "orbit --plot picture.gif " + kOneMode, "simulate --record all " + kOneMode,
           "simulate --periods 1.5 " + kOneMode, "check --threads 5000 " + kOneMode}) {
    const Finished run = run_graze(line);
    EXPECT_EQ(run.code, 2) << line;
    EXPECT_EQ(run.out, "") << line;
    EXPECT_NE(run.err, "") << line;
  }
}

TEST(Program, ValuesOfOptionsAreRefusedInWords) {
  const std::string trace = "continue " + kOneMode + " --parameter stop.gap ";
  for (const auto& [arguments, sentence] : std::vector<std::pair<std::string, std::string>>{
           {trace + "--from a --to 2", "--from: 'a' is not a finite number"},
           {trace + "--from 1 --to inf", "--to: 'inf' is not a finite number"},
           {trace + "--from 1 --to 2 --impacts 65",
            "--impacts: '65' is not a whole number from 0 to 64, or 'any'"},
           {trace + "--from 1 --to 2 --depth x", "--depth: 'x' is not a whole number from 1 to 16"},
           {trace + "--from 1 --to 2 --max-step 0", "--max-step: '0' is not a number above 0"}}) {
    const Finished run = run_graze(arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_EQ(run.err, "graze: " + sentence + " (see graze continue --help)\n");
  }
}

// The one-mode beam settles on a (1, 1) orbit: an answer only where no other period is asked for.
TEST(Program, AnOrbitOfAnotherPeriodIsNoAnswer) {
  const std::string settles = "orbit --start simulation --json " + kOneMode;
  const Finished any = run_graze(settles), one = run_graze(settles + " --period 1"),
                 two = run_graze(settles + " --period 2");
  EXPECT_EQ(any.code, 0) << any.err;
  EXPECT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(two.code, 3) << two.err;
  const json answer = json::parse(two.out);
  EXPECT_EQ(answer["outcome"], "none");
  EXPECT_TRUE(answer["orbits"].empty());
  EXPECT_NE(answer["notes"].dump().find("settles on a (1, 1) orbit"), std::string::npos);
}

TEST(Program, WholeNumbersMayBeWrittenWithAnExponent) {
  const Finished written = run_graze("simulate --periods 2e1 --json " + kOneMode);
  EXPECT_EQ(written.code, 0) << written.err;
  EXPECT_EQ(written.out, run_graze("simulate --periods 20 --json " + kOneMode).out);
}

// Wherever the scene stands among the options; each --set takes one value.
TEST(Program, OptionsStandInAnyOrder) {
  for (const std::string& line : std::vector<std::string>{
           "check " + kOneMode + " --set stop.gap=2e-3 --set beam.modes=2",
           "check --set stop.gap=2e-3 " + kOneMode + " --set beam.modes=2 --threads 1",
           "check --threads 1 --set stop.gap=2e-3 --set beam.modes=2 " + kOneMode}) {
    const Finished run = run_graze(line + " --json");
    EXPECT_EQ(run.code, 0) << line << run.err;
    EXPECT_EQ(
        run.out,
        run_graze("check --json --set stop.gap=2e-3 --set beam.modes=2 --threads 1 " + kOneMode)
            .out);
  }
}

TEST(Program, ATorqueFileThatIsNotThereExitsWith4) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "hub.toml")
      << "[beam]\nlength = 0.3\nyoungs_modulus = 2e11\nsecond_moment = 2e-13\ndensity = 8500\n"
         "area = 1e-5\nmodes = 2\n[hub]\nradius = 0.02\ninertia = 1e-3\n"
         "torque = { kind = \"table\", file = \"none.csv\" }\n";
  const Finished run = run_graze("check " + (scratch / "hub.toml").string());
  EXPECT_EQ(run.code, 4);
  EXPECT_NE(run.err.find((scratch / "none.csv").string() + ": cannot be read"), std::string::npos)
      << run.err;
}

TEST(Program, MissingSceneOrUnwritableFolderExitsWith4) {
  EXPECT_EQ(run_graze("check no/such/scene.toml").code, 4);
  EXPECT_EQ(run_graze("check .").code, 4);
  const ScratchFolder scratch;
  std::ofstream(scratch / "file") << "not a folder";
  for (const char* where : {"/file", "/file/below"}) {
    const Finished run = run_graze("orbit --out " + scratch.string() + where + " " + kOneMode);
    EXPECT_EQ(run.code, 4);
    EXPECT_EQ(run.out, "");
  }
  EXPECT_EQ(run_graze("check --out /proc/graze " + kOneMode).code, 4);
  EXPECT_EQ(read_text(scratch / "file"), "not a folder");
}

TEST(Program, FullDeviceExitsWith4) {
  const std::string line = std::string(GRAZE_PROGRAM) + " check " + kOneMode + " >/dev/full 2>&1";
  EXPECT_EQ(WEXITSTATUS(std::system(line.c_str())), 4);
}

TEST(Program, JsonIsOneDocumentWithTheContractsKeys) {
  const Finished run = run_graze("orbit --json --set forcing.frequency=40 " + kOneMode);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["graze"]["command"], "orbit");
  EXPECT_EQ(document["graze"]["version"], "0.1.0");
  EXPECT_EQ(document["graze"]["scene"], kOneMode);
  EXPECT_EQ(document["graze"]["scene_sha256"].get<std::string>().size(), 64U);
  EXPECT_EQ(document["outcome"], "found");
  EXPECT_FALSE(document.contains("message"));
  ASSERT_EQ(document["orbits"].size(), 1U);
  const json& orbit = document["orbits"][0];
  // Independent 40-digit values.
  EXPECT_NEAR(orbit["phases"][0].get<double>(), 0.201791940738459, 1e-12);
  EXPECT_NEAR(orbit["speeds"][0].get<double>(), 0.135344897739007, 1e-12);
  EXPECT_NEAR(orbit["multipliers"][0][0].get<double>(), 0.2163982916, 1e-9);
  EXPECT_NEAR(orbit["multipliers"][0][1].get<double>(), -0.7670857075, 1e-9);
  EXPECT_EQ(orbit["stable"], true);
  EXPECT_EQ(orbit["admissible"], true);
  EXPECT_TRUE(orbit["clearance"].is_null());
  EXPECT_EQ(orbit["at"][0]["stop"], 1);
}

TEST(Program, OrbitSpeaksOfTheSimulationOnlyWhereThereWasOne) {
  const std::string said = "simulation settle";
  const Finished preloaded = run_graze(
      "orbit --json --impacts 1 --start closed-form,simulation --set stop.gap=-1e-4 "
      "--set 'initial={q=[0.0],qdot=[0.0]}' " +
      kOneMode);
  EXPECT_EQ(preloaded.code, 3);
  EXPECT_EQ(preloaded.out.find(said), std::string::npos);
  EXPECT_NE(preloaded.err.find("no start by simulation"), std::string::npos);
  const Finished resting =
      run_graze("orbit --json --start simulation " + scene("02_wagg_momentum.toml"));
  EXPECT_EQ(resting.code, 3);
  EXPECT_NE(resting.out.find(said), std::string::npos);
}

TEST(Program, ContinueEndsAtGrazingsAndFoldsAreLocated) {
  const Finished run = run_graze(
      "continue --json --set forcing.frequency=40 --parameter stop.gap "
      "--from 0 --to 0.02 " +
      kOneMode);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "complete");
  EXPECT_EQ(document["parameter"], "stop.gap");
  ASSERT_EQ(document["branches"].size(), 1U);
  const json& branch = document["branches"][0];
  EXPECT_EQ(branch["ends"], json::array({"parameter limit", "GR"}));
  EXPECT_EQ(branch["special"][0]["label"], "LP");
  // Independent 40-digit value of the fold.
  EXPECT_NEAR(branch["special"][0]["value"].get<double>(), 0.0135928311243939, 1e-14);
  EXPECT_NEAR(branch["special"][0]["multiplier"][0].get<double>(), 1.0, 1e-6);
  EXPECT_GT(document["counters"]["shooting_evaluations"].get<int>(),
            static_cast<int>(branch["points"].size()));
  for (const json& point : branch["points"]) EXPECT_EQ(point["admissible"], true);
}

// Without damping and with r = 1 the impact map keeps areas: the product of its two multipliers is
// 1, and where they are no real pair they lie on the unit circle.
TEST(Program, ContinueSaysWhereStabilityIsOpen) {
  const std::string line = scene("04_impact_oscillator.toml") +
                           " --set 'modal.damping_ratios=[0.0]' --set stop.restitution=1"
                           " --parameter forcing.frequency --from 1.6 --to 1.8 --json";
  const Finished run = run_graze("continue " + line);
  EXPECT_EQ(run.code, 3) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "on_the_circle");
  EXPECT_NE(document["message"].get<std::string>().find("unit circle"), std::string::npos);
  ASSERT_EQ(document["branches"].size(), 1U);
  EXPECT_EQ(document["branches"][0]["ends"],
            json::parse(R"(["parameter limit", "parameter limit"])"));
  for (const json& point : document["branches"][0]["points"])
    EXPECT_TRUE(point["stable"].is_null());
  EXPECT_EQ(json::parse(run_graze("diagram --points 2 --periods 9 " + line).out)["outcome"],
            "on_the_circle");
}

// Between its two stops one mode has an orbit that is the mirror image of itself; where it loses
// that symmetry two others branch off. Each passes the branch point, with a multiplier of 1.
TEST(Program, ContinueTakesNoBranchPointForOpenStability) {
  const Finished run = run_graze("continue " + scene("07_two_stops.toml") +
                                 " --set beam.modes=1 --parameter forcing.frequency --from 20"
                                 " --to 40 --impacts 2 --follow all --json");
  EXPECT_EQ(run.code, 0);
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "complete");
  EXPECT_EQ(std::count_if(document["branches"].begin(), document["branches"].end(),
                          [](const json& branch) { return branch["origin"] == "BP1"; }),
            1);
}

TEST(Program, OutWritesTheDocumentTheSceneAndTheTables) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "deep/er").string();
  const Finished run =
      run_graze("continue --json --parameter stop.gap --from 1e-3 --to 2e-3 --out " + folder + " " +
                kOneMode);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(read_text(folder + "/result.json"), run.out);
  EXPECT_EQ(read_text(folder + "/branches.csv").substr(0, 17), "branch,component,");
  EXPECT_EQ(read_text(folder + "/special.csv").substr(0, 9), "id,label,");
  // The scene that was written makes the same result again.
  const Finished again = run_graze("continue --json --parameter stop.gap --from 1e-3 --to 2e-3 " +
                                   folder + "/scene.toml");
  EXPECT_EQ(json::parse(again.out)["branches"], json::parse(run.out)["branches"]);
  EXPECT_EQ(json::parse(again.out)["graze"]["scene_sha256"],
            json::parse(run.out)["graze"]["scene_sha256"]);
}

TEST(Program, PicturesAreDrawnWithTheirScript) {
  const ScratchFolder scratch;
  for (const char* extension : {"svg", "png", "pdf"}) {
    const std::string picture = (scratch / (std::string("x.") + extension)).string();
    for (const std::string& line : std::vector<std::string>{
             "simulate --periods 20 " + kOneMode, "orbit " + kOneMode,
             "continue --parameter stop.gap --from 1e-3 --to 2e-3 " + kOneMode}) {
      const Finished run = run_graze(line + " --plot " + picture);
      EXPECT_EQ(run.code, 0) << run.err;
      EXPECT_GT(read_text(picture).size(), 1000U) << line;
      EXPECT_GT(read_text(scratch / "x.gp").size(), 100U) << line;
      std::filesystem::remove(picture);
    }
  }
}

TEST(Program, ThreadsDoNotChangeTheBytesOfASearch) {
  const std::string lines[] = {
      " --json --start random --random-seed 7 --set beam.modes=2 --virtual " + kOneMode,
      " --json --impacts 2 --virtual " + scene("07_two_stops.toml"),
      " --json " + scene("04_impact_oscillator.toml")};
  for (const std::string& line : lines) {
    SCOPED_TRACE(line);
    const Finished one = run_graze("orbit --threads 1" + line);
    EXPECT_EQ(one.code, 0) << one.err;
    EXPECT_EQ(run_graze("orbit --threads 2" + line).out, one.out);
    EXPECT_EQ(run_graze("orbit --threads 5" + line).out, one.out);
  }
}

// Exit code 3, and the sentence says what was tried.
TEST(Program, ASearchInVainSaysWhatItTried) {
  const Finished run = run_graze("orbit --json --impacts 3 --set stop.gap=1.0 " + kOneMode);
  EXPECT_EQ(run.code, 3);
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "none");
  EXPECT_TRUE(document["orbits"].empty());
  const std::string message = document["message"];
  EXPECT_NE(message.find("random starts on 1 sequence of stops"), std::string::npos) << message;
  EXPECT_NE(message.find("global minimisations"), std::string::npos) << message;
  EXPECT_EQ(document["starts"]["global"]["converged"], 0);
  EXPECT_GT(document["starts"]["random"]["tried"], 0);
}

}  // namespace
}  // namespace graze
