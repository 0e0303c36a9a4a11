// Results of scenes without units, and over frequencies in Hz.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>

#include "apps/program.hpp"

namespace graze {
namespace {

using nlohmann::json;

constexpr double kTwoPi = 2.0 * std::numbers::pi;

// One mode with two probes and a stop, in numbers that are pure.
std::string pure_scene(const ScratchFolder& folder,
                       const std::string& head = "units = \"none\"\n") {
  const std::string file = (folder / "pure.toml").string();
  std::ofstream(file) << head
                      << "[modal]\nfrequencies = [1.0]\nparticipation = [1.0]\n"
                         "damping_ratios = [0.05]\n[forcing]\namplitude = 1.0\nfrequency = 2.8\n"
                         "[[stop]]\nshape = [1.0]\ngap = 0.0\nrestitution = 0.8\n"
                         "[[probe]]\nshape = [1.0]\nquantity = \"velocity\"\n";
  return file;
}

TEST(UnitsNone, NothingPrintedHasAUnit) {
  const ScratchFolder folder;
  const std::string file = pure_scene(folder);
  const std::regex unit(R"((\((rad|m|s|1/s|N|J|kg|Hz)([ /^][^)]*)?\)|\d (rad|m|s|N|J|kg|Hz)\b))");
  for (const std::string& command :
       {std::string("check "), std::string("simulate --energy --amplitudes "),
        std::string("orbit "),
        std::string("continue --parameter forcing.frequency --from 2.5 --to 3 --amplitudes "),
        std::string("diagram --parameter stop.gap --from 0 --to 0.1 --points 5 --exponents 20 "),
        std::string("map --parameter forcing.frequency --from 2.5 --to 3 --points 3 "
                    "--second stop.gap --second-from 0 --second-to 0.1 --second-points 3 "),
        std::string("compare --against stop.restitution=0.7 ")}) {
    const Finished run = run_graze(command + file);
    EXPECT_TRUE(run.code == 0 || run.code == 3) << command << run.err;
    EXPECT_FALSE(std::regex_search(run.out, unit)) << command << "\n" << run.out;
    const json document = json::parse(run_graze(command + "--json " + file).out);
    EXPECT_FALSE(document.contains("units")) << command;
    EXPECT_EQ(document.dump().find("\"unit\":\"m"), std::string::npos) << command;
  }
  // The same scene with units prints them: the pattern finds what it is to find.
  const Finished run = run_graze("simulate --energy " + pure_scene(folder, ""));
  EXPECT_TRUE(std::regex_search(run.out, unit)) << run.out;
}

TEST(UnitsNone, ChangesNoNumber) {
  const ScratchFolder folder;
  const std::string command = "orbit --json ";
  const json pure = json::parse(run_graze(command + pure_scene(folder)).out),
             with_units = json::parse(run_graze(command + pure_scene(folder, "")).out);
  EXPECT_EQ(pure["orbits"], with_units["orbits"]);
}

// Orbits at 7 Hz are those at 14 pi rad/s.
TEST(FrequencyInHertz, OrbitsAreThoseOfTheSameFrequency) {
  const std::string command = "orbit --start closed-form --json " + scene("05_wagg_one_mode.toml");
  const json hertz =
      json::parse(run_graze(command + " --set forcing.frequency_hz=7").out)["orbits"];
  const json angular =
      json::parse(run_graze(command + " --set forcing.frequency=43.982297150257104").out)["orbits"];
  ASSERT_EQ(hertz.size(), 1U);
  ASSERT_EQ(angular.size(), 1U);
  EXPECT_NEAR(hertz[0]["phases"][0], angular[0]["phases"][0], 1e-12);
  EXPECT_NEAR(hertz[0]["speeds"][0], angular[0]["speeds"][0], 1e-12);
}

TEST(FrequencyInHertz, BranchesAreInHertz) {
  const std::string command = "continue " + scene("05_wagg_one_mode.toml") + " --parameter ";
  const Finished hertz = run_graze(command + "forcing.frequency_hz --from 2.5 --to 13 --json"),
                 angular = run_graze(command +
                                     "forcing.frequency --from 15.707963267948966"
                                     " --to 81.68140899333463 --json");
  ASSERT_EQ(hertz.code, 0) << hertz.err;
  const json document = json::parse(hertz.out), other = json::parse(angular.out);
  EXPECT_EQ(document["parameter"], "forcing.frequency_hz");
  EXPECT_EQ(document["units"]["value"], "Hz");
  std::vector<double> in_hertz, in_angular;
  for (const json& branch : document["branches"])
    for (const json& special : branch["special"]) in_hertz.push_back(special["value"]);
  for (const json& branch : other["branches"])
    for (const json& special : branch["special"]) in_angular.push_back(special["value"]);
  ASSERT_EQ(in_hertz.size(), in_angular.size());
  ASSERT_FALSE(in_hertz.empty());
  for (std::size_t i = 0; i < in_hertz.size(); ++i)
    EXPECT_NEAR(kTwoPi * in_hertz[i], in_angular[i], 1e-9 * in_angular[i]);
  const std::string text = run_graze(command + "forcing.frequency_hz --from 2.5 --to 13").out;
  EXPECT_NE(text.find("(Hz)"), std::string::npos) << text;
  EXPECT_EQ(text.find("rad/s"), std::string::npos) << text;
}

// What a run leaves has the frequency as it was given.
TEST(FrequencyInHertz, IsKeptInTheFolder) {
  const ScratchFolder folder;
  const std::string out = (folder / "run").string();
  ASSERT_EQ(run_graze("orbit " + scene("05_wagg_one_mode.toml") +
                      " --set forcing.frequency_hz=7 --out " + out)
                .code,
            0);
  EXPECT_NE(read_text(out + "/scene.toml").find("\nfrequency_hz = 7"), std::string::npos);
}

// A special point over one of the units is gone on from over the other.
TEST(FrequencyInHertz, RestartsInEitherUnit) {
  const ScratchFolder folder;
  const std::string out = (folder / "run").string(), file = scene("05_wagg_one_mode.toml");
  ASSERT_EQ(run_graze("continue " + file +
                      " --parameter forcing.frequency_hz --from 8 --to 12 --out " + out)
                .code,
            0);
  const Finished restarted = run_graze("continue " + file + " --restart " + out +
                                       " --label PD1 --switch --parameter forcing.frequency"
                                       " --from 50 --to 75 --json");
  ASSERT_EQ(restarted.code, 0) << restarted.err;
  const json document = json::parse(restarted.out);
  ASSERT_FALSE(document["branches"].empty());
  EXPECT_EQ(document["branches"][0]["period"], 2);
}

}  // namespace
}  // namespace graze
