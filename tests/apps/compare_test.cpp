// graze compare: scenes side by side, over a plane, and over numbers of modes.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace graze {
namespace {

using nlohmann::json;

const std::string kPaper = scene("01_wagg_2004.toml");
const std::string kGalerkin = "--against beam.discretisation=galerkin ";
const std::string kComparedPlane =
    "compare --quiet --against stop.restitution=0.7 --parameter forcing.frequency --from 30 --to "
    "90 "
    "--points 7 --second stop.gap --second-from 0.5e-3 --second-to 2e-3 --second-points 4 " +
    scene("05_wagg_one_mode.toml");

long long lines_in(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST(CompareCommand, PutsTwoScenesSideBySide) {
  const ScratchFolder out;
  const Finished run = run_graze("compare --json --out " + (out / "run").string() + " --plot " +
                                 (out / "two.svg").string() + " " + kGalerkin + kPaper);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "compared");
  ASSERT_EQ(document["motions"].size(), 2u);
  EXPECT_EQ(document["motions"][1]["name"], "beam.discretisation=galerkin");
  EXPECT_EQ(document["motions"][0]["first_impacts"].size(), 20u);
  ASSERT_EQ(document["differences"].size(), 1u);
  const json& apart = document["differences"][0];
  // Both are driven from rest; how the load is spread over the modes moves the first impact.
  EXPECT_NE(apart["first_time"], 0.0);
  EXPECT_LT(std::abs(apart["first_time"].get<double>()), 0.01);
  EXPECT_EQ(lines_in(read_text(out / "run" / "comparison.csv")), 3);
  EXPECT_EQ(lines_in(read_text(out / "run" / "first_impacts.csv")), 41);
  EXPECT_NE(read_text(out / "two.svg").find("galerkin"), std::string::npos);
}

TEST(CompareCommand, ComparesNumbersOfModes) {
  const ScratchFolder out;
  const Finished run = run_graze("compare --modes 1:4 --periods 200 --plot " +
                                 (out / "n.png").string() + " " + scene("02_wagg_momentum.toml"));
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("3 modes to 4 modes"), std::string::npos) << run.out;
  EXPECT_GT(read_text(out / "n.png").size(), 3000u);
}

// The structure's own key is set, whatever it is called: of matrices the modes are found anew.
TEST(CompareCommand, ComparesNumbersOfModesOfEveryStructure) {
  const ScratchFolder out;
  const std::string driven =
      "[damping]\nrayleigh = { mass = 20.0, stiffness = 0.0 }\n"
      "[forcing]\namplitude = 1e-3\nfrequency = 60.0\n"
      "[[stop]]\nposition = 0.37\ngap = 5e-4\nrestitution = 0.6\n";
  std::ofstream(out / "string.toml")
      << "[string]\nlength = 0.863\ntension = 1.9\nmass_per_length = 0.0067\nmodes = 1\n" + driven;
  std::ofstream(out / "bar.toml") << "[bar]\nlength = 0.863\nyoungs_modulus = 2e6\n"
                                     "density = 7800\narea = 1e-4\nmodes = 1\n" +
                                         driven;
  for (const auto& [file, key] : {std::pair(scene("24_frame_from_matrices.toml"), "matrices.modes"),
                                  std::pair((out / "string.toml").string(), "string.modes"),
                                  std::pair((out / "bar.toml").string(), "bar.modes")}) {
    SCOPED_TRACE(key);
    const Finished run = run_graze("compare --json --modes 2:4 --periods 50 --samples 5 " + file);
    ASSERT_EQ(run.code, 0) << run.err;
    const json motions = json::parse(run.out)["motions"];
    ASSERT_EQ(motions.size(), 3u);
    for (int modes = 2; modes <= 4; ++modes) {
      // As many modes move as the same scene has that says so.
      const Finished alone =
          run_graze("compare --json --periods 50 --samples 5 --set " + std::string(key) + "=" +
                    std::to_string(modes) + " --against stop.restitution=0.5 " + file);
      ASSERT_EQ(alone.code, 0) << alone.err;
      const json& motion = motions[static_cast<std::size_t>(modes - 2)];
      EXPECT_EQ(motion["name"], std::to_string(modes) + " modes");
      EXPECT_FALSE(motion["first_impacts"].empty());
      EXPECT_EQ(motion["first_impacts"], json::parse(alone.out)["motions"][0]["first_impacts"]);
    }
    EXPECT_NE(motions[0]["first_impacts"], motions[1]["first_impacts"]);
  }
}

TEST(CompareCommand, DrawsEveryDifferenceOverAPlane) {
  const ScratchFolder out;
  for (const std::string what : {"attractor", "agreeing", "first_speed", "velocity", "energy"}) {
    const Finished run = run_graze(kComparedPlane + " --show " + what + " --out " +
                                   (out / "run").string() + " --plot " + (out / "m.svg").string());
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string title = what == "attractor"     ? "both (1,1)"
                              : what == "agreeing"    ? "first impacts that agree"
                              : what == "first_speed" ? "speed of the first impact"
                              : what == "velocity"    ? "velocity, rms difference"
                                                      : "mean energy, relative";
    EXPECT_NE(read_text(out / "m.svg").find(title), std::string::npos) << what;
  }
  const json document = json::parse(read_text(out / "run" / "result.json"));
  EXPECT_EQ(document["outcome"], "complete");
  for (const char* key : {"one", "other", "attractor", "agreeing", "first_time", "energy"})
    EXPECT_EQ(document["cells"][key].size(), 28u) << key;
  EXPECT_EQ(lines_in(read_text(out / "run" / "comparison.csv")), 29);
}

TEST(CompareCommand, IsSharedOutAndGoesOn) {
  const ScratchFolder out;
  ASSERT_EQ(run_graze(kComparedPlane + " --out " + (out / "whole").string()).code, 0);
  std::string folders;
  for (const char* share : {"1/2", "2/2"}) {
    const std::string folder = (out / ("part" + std::string(1, share[0]))).string();
    EXPECT_EQ(run_graze(kComparedPlane + " --shard " + share + " --out " + folder).code, 0);
    folders += folder + " ";
  }
  const Finished merged = run_graze("merge " + folders + "--out " + (out / "joined").string());
  ASSERT_EQ(merged.code, 0) << merged.err;
  EXPECT_EQ(run_graze(kComparedPlane + " --resume --out " + (out / "part1").string()).code, 0);
  for (const char* folder : {"joined", "part1"})
    for (const char* file : {"result.json", "comparison.csv"})
      EXPECT_EQ(read_text(out / folder / file), read_text(out / "whole" / file)) << folder << file;
}

// The time that a comparison may take holds for its picture too.
TEST(CompareCommand, SaysWhereThePictureWasCut) {
  const ScratchFolder out;
  const Finished run = run_graze(
      "compare --against stop.restitution=0.7 --duration 1000 "
      "--max-impacts 3000 --plot " +
      (out / "cut.svg").string() + " " + scene("05_wagg_one_mode.toml"));
  EXPECT_EQ(run.code, 3) << run.out;
  EXPECT_NE(run.out.find("for the picture"), std::string::npos) << run.out;
}

TEST(CompareCommand, SaysWhatIsMissing) {
  const auto refuses = [](const std::string& arguments, const std::string& words) {
    const Finished run = run_graze("compare " + arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
  };
  refuses(kPaper, "--against");
  refuses("--modes 1:3 " + kGalerkin + kPaper, "one of");
  refuses("--modes 3:1 " + kPaper, "like 1:8");
  refuses("--parameter stop.gap --from 0 --to 1 " + kGalerkin + kPaper, "--second");
  refuses("--against beam.discretisation=galerking " + kPaper, "galerkin");
  refuses("--resume --out x " + kGalerkin + kPaper, "--parameter");
  refuses("--parameter stop.gap --second forcing.frequency --second-from 20 --second-to 30 " +
              kGalerkin + kPaper,
          "--from");
  refuses("--show taken " + kGalerkin + kPaper, "--parameter");
  refuses("--second-values 1,2 " + kGalerkin + kPaper, "--second");
  refuses("--sensitivity --parameter stop.gap --from 1 --to 2 --duration 1 --shard 1/2 " + kPaper,
          "--shard");
  refuses(
      "--parameter stop.gap --from 1e-3 --to 2e-3 --points 10000 --second forcing.frequency "
      "--second-from 20 --second-to 30 --second-points 10000 " +
          kGalerkin + kPaper,
      "too many");
  refuses("--sensitivity " + kGalerkin + kPaper, "--against");
  refuses("--modes 1:3 " + scene("04_impact_oscillator.toml"),
          "04_impact_oscillator.toml:13:1: modal: the modes of this scene are given");
  refuses(kGalerkin + scene("06_bouncing_ball.toml"), "forcing");
}

}  // namespace
}  // namespace graze
