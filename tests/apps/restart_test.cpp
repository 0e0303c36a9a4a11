// Going on from a special point of an earlier run.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace graze {
namespace {

using nlohmann::json;

const std::string kOverFrequency = " --parameter forcing.frequency --from 50 --to 75 ";

// The one-mode beam at a gap of 1.1 mm, whose (1, 1) orbit doubles its period once in the range.
class Restart : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch_ = new ScratchFolder;
    const Finished run = run_graze("continue --json --out " + folder() + kOverFrequency +
                                   "--set stop.gap=1.1e-3 " + scene("05_wagg_one_mode.toml"));
    ASSERT_EQ(run.code, 0) << run.err;
    const json document = json::parse(run.out);
    for (const json& branch : document["branches"])
      for (const json& special : branch["special"])
        if (special["id"] == "PD1") doubling_ = special;
    ASSERT_FALSE(doubling_.is_null());
  }
  static void TearDownTestSuite() { delete scratch_; }

  static std::string folder() { return (*scratch_ / "first").string(); }
  static Finished again(const std::string& what) {
    return run_graze("continue " + folder() + "/scene.toml --restart " + folder() + " " + what);
  }
  static json document(const std::string& what) {
    const Finished run = again("--json " + what);
    EXPECT_EQ(run.code, 0) << run.out << run.err;
    return json::parse(run.out);
  }

  static ScratchFolder* scratch_;
  static json doubling_;
};

ScratchFolder* Restart::scratch_ = nullptr;
json Restart::doubling_;

// The one special point with this label.
json only(const json& document, const std::string& label) {
  json found;
  for (const json& branch : document["branches"])
    for (const json& special : branch["special"])
      if (special["label"] == label) {
        EXPECT_TRUE(found.is_null());
        found = special;
      }
  EXPECT_FALSE(found.is_null()) << label;
  return found;
}

TEST_F(Restart, GoesFurtherAlong) {
  const json wider = document("--label PD1 --parameter forcing.frequency --from 45 --to 90");
  ASSERT_EQ(wider["branches"].size(), 1u);
  EXPECT_EQ(wider["branches"][0]["points"].front()["value"], 45.0);
  EXPECT_NEAR(only(wider, "PD")["value"].get<double>(), doubling_["value"].get<double>(), 1e-10);
}

// The orbit is the same one, so where it doubles over the gap its gap is the run's own.
TEST_F(Restart, GoesOnInAnotherParameter) {
  const json over_gap = document("--label PD1 --parameter stop.gap --from 1e-3 --to 2e-3");
  const json special = only(over_gap, "PD");
  EXPECT_NEAR(special["value"].get<double>(), 1.1e-3, 1e-13);
  EXPECT_NEAR(special["phase"].get<double>(), doubling_["phase"].get<double>(), 1e-9);
  EXPECT_NEAR(special["speed"].get<double>(), doubling_["speed"].get<double>(), 1e-12);
}

// Doublings end at the grazing of the motion without impacts, where the free beam makes half a turn
// in a forcing period: at Omega = 2 w_d, w_d of the scene's first mode.
TEST_F(Restart, GoesOnAsALocus) {
  const json plane = document(
      "--label PD1 --parameter forcing.frequency --from 50 --to 65 --locus PD --second stop.gap "
      "--second-from 5e-4 --second-to 1.5e-3");
  ASSERT_EQ(plane["loci"].size(), 1u);
  ASSERT_EQ(plane["loci"][0]["special"].size(), 1u);
  EXPECT_EQ(plane["loci"][0]["special"][0]["label"], "PDGR");
  const json modes =
      json::parse(run_graze("check --json " + scene("05_wagg_one_mode.toml")).out)["modes"][0];
  const double frequency = modes["frequency"].get<double>(),
               decay = modes["decay_rate"].get<double>();
  EXPECT_NEAR(plane["loci"][0]["special"][0]["value"].get<double>(),
              2.0 * std::sqrt(frequency * frequency - decay * decay), 1e-8);
}

TEST_F(Restart, SwitchesOntoTheDoubledOrbits) {
  const json doubled = document("--label PD1 --switch" + kOverFrequency);
  ASSERT_EQ(doubled["branches"].size(), 1u);
  const json& branch = doubled["branches"][0];
  EXPECT_EQ(branch["period"], 2);
  EXPECT_EQ(branch["impacts"], 2);
  EXPECT_EQ(branch["ends"][0], "PD");
  EXPECT_NEAR(branch["points"].front()["value"].get<double>(), doubling_["value"].get<double>(),
              1e-6);
}

// A run that was gone on from is one to go on from: over the gap and back.
TEST_F(Restart, CanBeRestartedItself) {
  const std::string second = (*scratch_ / "second").string();
  const Finished run =
      again("--label PD1 --parameter stop.gap --from 1e-3 --to 2e-3 --out " + second);
  ASSERT_EQ(run.code, 0) << run.err;
  const Finished back = run_graze("continue --json " + second + "/scene.toml --restart " + second +
                                  " --label PD1" + kOverFrequency);
  ASSERT_EQ(back.code, 0) << back.err;
  EXPECT_NEAR(only(json::parse(back.out), "PD")["value"].get<double>(),
              doubling_["value"].get<double>(), 1e-9);
}

TEST_F(Restart, SaysWhatIsWrong) {
  struct Case {
    std::string what, sentence;
  };
  for (const Case& wrong : {
           Case{kOverFrequency, "give --label ID"},
           Case{"--label PD9" + kOverFrequency, "has no special point PD9; there are "},
           Case{"--label PD1 --set stop.gap=2e-3" + kOverFrequency,
                "it has '[[stop]] gap = 0.0011', this one '[[stop]] gap = 0.002'"},
           Case{"--label PD1 --set beam.modes=2" + kOverFrequency, "modes = 1"},
           Case{"--label PD1 --out " + folder() + kOverFrequency, "give another folder"},
           Case{"--label PD1 --parameter forcing.frequency --from 60 --to 75",
                "which the range from 60 to 75 does not hold"},
           Case{"--label PD1 --period 2" + kOverFrequency, "--restart"},
           Case{"--label GR1 --switch" + kOverFrequency, "the motion meets no stop"},
           Case{"--label PD1 --locus LP --second stop.gap --second-from 1e-3 --second-to 2e-3" +
                    kOverFrequency,
                "give --locus PD or all"},
       }) {
    SCOPED_TRACE(wrong.what);
    const Finished run = again(wrong.what);
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find(wrong.sentence), std::string::npos) << run.err;
  }
  EXPECT_EQ(run_graze("continue " + folder() + "/scene.toml --label PD1 --restart " + folder() +
                      "/nowhere" + kOverFrequency)
                .code,
            4);
  const ScratchFolder scratch;
  const std::string orbits = (scratch / "orbits").string();
  ASSERT_EQ(run_graze("orbit --out " + orbits + " " + scene("05_wagg_one_mode.toml")).code, 0);
  const Finished none = run_graze("continue " + orbits + "/scene.toml --label PD1 --restart " +
                                  orbits + kOverFrequency);
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("holds no branches"), std::string::npos) << none.err;
}

// The scene may differ in what its orbits do not depend on, and in the run's own parameter.
TEST_F(Restart, TakesASceneThatDiffersInWhatDoesNotMatter) {
  EXPECT_EQ(
      again("--label PD1 --set forcing.frequency=33 --set solver.tolerance=1e-8" + kOverFrequency)
          .code,
      0);
}

// tests/reference/chatter_points.csv, Z2b_r
TEST(RestartOfOrbitsThatStick, GoesOnFromWhereAChatterCompletes) {
  const ScratchFolder scratch;
  const std::string first = (scratch / "first").string();
  const std::string range = " --parameter stop.restitution --from 0.1 --to 0.6 ";
  const Finished run =
      run_graze("continue " + reference_case("sticking/Z2b.toml") + range + "--out " + first);
  ASSERT_EQ(run.code, 0) << run.err;
  const Finished again = run_graze("continue --json " + first + "/scene.toml --restart " + first +
                                   " --label CH1" + range);
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_NEAR(only(json::parse(again.out), "CH")["value"].get<double>(), 0.5134941368753766,
              0.5e-10);
}

// Between two doublings of orbits that stick: each of them is told by a multiplier there, and by
// the halves of the doubled orbits here.
TEST(RestartOfOrbitsThatStick, SwitchesOntoTheDoubledOrbits) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "first").string();
  const std::string range = " --parameter forcing.frequency --from 39.5 --to 41 --max-step 0.05 ";
  const Finished first =
      run_graze("continue --json --out " + folder + range + scene("09_soft_stop_two_modes.toml"));
  ASSERT_EQ(first.code, 0) << first.err;
  std::vector<double> doublings;
  const json traced = json::parse(first.out);
  for (const json& branch : traced["branches"])
    for (const json& special : branch["special"])
      if (special["label"] == "PD") doublings.push_back(special["value"].get<double>());
  ASSERT_EQ(doublings.size(), 2u);
  const Finished run = run_graze("continue --json --switch --label PD1 " + folder +
                                 "/scene.toml --restart " + folder + range);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  ASSERT_EQ(document["branches"].size(), 1u);
  const json& doubled = document["branches"][0];
  EXPECT_EQ(doubled["period"], 2);
  EXPECT_EQ(doubled["stuck"], true);
  EXPECT_EQ(doubled["ends"], json({"PD", "PD"}));
  EXPECT_NEAR(doubled["points"].front()["value"].get<double>(), doublings[0], 1e-8);
  EXPECT_NEAR(doubled["points"].back()["value"].get<double>(), doublings[1], 1e-8);
}

}  // namespace
}  // namespace graze
