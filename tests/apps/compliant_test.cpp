// Compliant stops as a user meets them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "graze/contact/detail/restitution_damping.hpp"
#include "program.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

using nlohmann::json;

// A mass of 1 kg that flies at 0.5 m/s against a damped Hertz contact 0.1 m away.
constexpr const char* kScene = R"(
[modal]
frequencies = [0.0]

[[stop]]
shape = [1.0]
gap = 0.1

[stop.spring]
stiffness = 1e8
exponent = 1.5
damping = { model = "hunt-crossley", restitution = 0.5, speed = 0.5 }

[initial]
qdot = [0.5]
)";

class Compliant : public ::testing::Test {
 protected:
  std::string file() {
    const std::filesystem::path path = scratch_ / "scene.toml";
    std::ofstream(path) << kScene;
    return path.string();
  }
  ScratchFolder scratch_;
};

TEST_F(Compliant, ContactsComeWithTheirForceAndRestitution) {
  const Finished run = run_graze("simulate --json --duration 0.5 --out " +
                                 (scratch_ / "run").string() + " " + file());
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  const json& events = document["events"];
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0]["kind"], "contact");
  EXPECT_NEAR(events[0]["time"].get<double>(), 0.2, 1e-13);
  EXPECT_NEAR(events[0]["speed"].get<double>(), 0.5, 1e-13);
  EXPECT_EQ(events[1]["kind"], "separation");
  EXPECT_NEAR(events[1]["effective_restitution"].get<double>(), 0.6629622, 5e-8);
  EXPECT_NEAR(events[1]["speed"].get<double>(), 0.5 * 0.6629622, 5e-8);
  EXPECT_GT(events[1]["peak_force"].get<double>(), 0.0);
  EXPECT_NEAR(events[1]["time"].get<double>() - events[0]["time"].get<double>(),
              events[1]["duration"].get<double>(), 1e-15);
  EXPECT_NEAR(document["final"]["qdot"][0].get<double>(), -0.5 * 0.6629622, 5e-8);
  // What was written is read again.
  const Finished again =
      run_graze("simulate --json --duration 0.5 " + (scratch_ / "run" / "scene.toml").string());
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(json::parse(again.out)["events"], events);
}

// 100 kg on 1e4 N/m thrown with 1 m/s at a spring of 1e6 N/m that it touches: u = sin(W t)/W with
// W^2 = (1e4 + 1e6)/100, and the contact force is 1e6 u.
TEST_F(Compliant, AContactCutByTheEndTellsItsForce) {
  const std::string scene =
      std::string(GRAZE_SOURCE_DIR) + "/data/validation/code_aster_sdnd101.toml";
  const double w = std::sqrt(1.01e4);
  for (const std::string time : {"0.01", "0.015", "0.03"}) {
    const Finished run = run_graze("simulate --json --duration " + time + " " + scene);
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NEAR(json::parse(run.out)["final"]["forces"][0].get<double>(),
                1e6 * std::sin(w * std::stod(time)) / w, 1e-7);
  }
  // A mass is at no distance along a beam.
  const Finished curve = run_graze(
      "compare --sensitivity --json --parameter stop.gap --from 0 --to 1e-3 --points 2 "
      "--duration 0.01 --set probe.mass=1 " +
      scene);
  ASSERT_EQ(curve.code, 0) << curve.err;
  EXPECT_TRUE(json::parse(curve.out)["probes"][0]["position"].is_null());
}

TEST_F(Compliant, InversionIsExact) {
  const Finished run = run_graze(
      "simulate --json --duration 0.5 --set 'stop.spring.damping.inversion=\"exact\"' " + file());
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NEAR(json::parse(run.out)["events"][1]["effective_restitution"].get<double>(), 0.5, 1e-11);
}

TEST_F(Compliant, CheckSaysWhatTheStopIs) {
  const Finished run = run_graze("check " + file());
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("compliant: 1e+08 N/m^1.5 with hunt-crossley damping 1.5e+08"),
            std::string::npos)
      << run.out;
}

TEST_F(Compliant, CheckSaysWhatWasAskedForAndWhatItGives) {
  const Finished run = run_graze("check --wide " + file());
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("stop 1: requested restitution 0.5 at 0.5 m/s, one contact gives "
                         "0.662962; exact with the coefficient "),
            std::string::npos)
      << run.out;
  const json stop = json::parse(run_graze("check --json " + file()).out)["stops"][0];
  const json& asked = stop["spring"]["restitution"];
  EXPECT_EQ(asked["requested"], 0.5);
  EXPECT_EQ(asked["speed"], 0.5);
  EXPECT_TRUE(asked["mass"].is_null());
  EXPECT_NEAR(asked["effective"].get<double>(), 0.6629622, 5e-8);
  // Given that coefficient, the contact meets what was asked for.
  const std::string exact = asked["exact_coefficient"].dump();
  const std::string set =
      " --set 'stop.spring.damping={model=\"hunt-crossley\",coefficient=" + exact + "}' " + file();
  const json events = json::parse(run_graze("simulate --json --duration 0.5" + set).out)["events"];
  EXPECT_NEAR(events[1]["effective_restitution"].get<double>(), 0.5, 1e-11);
  EXPECT_TRUE(json::parse(run_graze("check --json" + set).out)["stops"][0]["spring"]["restitution"]
                  .is_null());
}

TEST_F(Compliant, CheckNamesTheMassAndTheOnset) {
  const Finished run = run_graze(
      "check --wide --set 'stop.spring={stiffness=1e6,exponent=1,damping={model=\"lee-wang-2\","
      "restitution=0.5,mass=2.0,onset=1e-6},release=\"position\"}' " +
      file());
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("requested restitution 0.5 of 2 kg, one contact gives 0.5, and more"),
            std::string::npos)
      << run.out;
}

TEST_F(Compliant, TheEnergyBalanceCloses) {
  const Finished run = run_graze("simulate --json --energy --duration 0.5 " + file());
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  const json& balance = document["energy"];
  EXPECT_TRUE(balance["impacts"].is_null());
  EXPECT_NEAR(balance["contact"].get<double>(), -0.125 * (1.0 - 0.6629622 * 0.6629622), 1e-8);
  // A contact takes some forty steps, each of which errs by 1e-14 of the velocities: twice that of
  // the energy, .125 J.
  EXPECT_LT(std::abs(balance["defect"].get<double>()), 40 * 2e-14 * 0.125);
  EXPECT_EQ(document["events"][1]["energy_change"], document["energy"]["contact"]);
}

const std::string kDashpotOscillator = scene("12_spring_dashpot_oscillator.toml");

TEST(CompliantOrbits, ComeWithTheirContacts) {
  ScratchFolder scratch;
  const Finished run = run_graze("orbit --json --out " + (scratch / "run").string() +
                                 " --set forcing.frequency=2.4 " + kDashpotOscillator);
  ASSERT_EQ(run.code, 0) << run.err;
  const json orbits = json::parse(run.out)["orbits"];
  ASSERT_FALSE(orbits.empty());
  for (const json& orbit : orbits) {
    double lost = 0.0;
    for (const json& at : orbit["at"]) {
      EXPECT_NEAR(at["effective_restitution"].get<double>(), 0.8, 0.05);
      EXPECT_GT(at["duration"].get<double>(), 0.0);
      EXPECT_GT(at["peak_force"].get<double>(), 0.0);
      lost -= at["energy_change"].get<double>();
    }
    EXPECT_GT(lost, 0.0);
    EXPECT_EQ(orbit["section"]["q"].size(), 1u);
  }
  EXPECT_EQ(lines_of((scratch / "run" / "contacts.csv").string())[0],
            "orbit,impact,stop,duration,peak_force,effective_restitution,energy_change");
  EXPECT_NE(run_graze("orbit --wide --set forcing.frequency=2.4 " + kDashpotOscillator)
                .out.find("effective restitution"),
            std::string::npos);
}

// Without damping and between elastic springs the motion over a period keeps volumes (Liouville):
// multipliers never lie all inside the unit circle, and those of a motion that is not unstable lie
// on it. On which side rounding has them says nothing.
TEST(CompliantOrbits, OfAConservativeStructureAreNeverStable) {
  int on_the_circle = 0;
  for (const std::string frequency : {"0.4", "0.5", "0.55", "0.6", "0.7", "0.8"}) {
    const Finished run =
        run_graze("orbit --json --impacts 2 --start random --set forcing.frequency=" + frequency +
                  " " + std::string(GRAZE_SOURCE_DIR) + "/data/validation/den_hartog_mikina.toml");
    ASSERT_TRUE(run.code == 0 || run.code == 3) << run.err;
    const json document = json::parse(run.out);
    for (const json& orbit : document["orbits"]) {
      double largest = 0.0;
      for (const json& multiplier : orbit["multipliers"])
        largest =
            std::max(largest, std::hypot(multiplier[0].get<double>(), multiplier[1].get<double>()));
      if (largest > 1.0 + 1e-6) {
        EXPECT_EQ(orbit["stable"], false);
        continue;
      }
      EXPECT_TRUE(orbit["stable"].is_null()) << frequency << ": " << orbit["stable"];
      ++on_the_circle;
    }
  }
  EXPECT_GE(on_the_circle, 6);
}

TEST(CompliantOrbits, GoOnFromTheirSpecialPoints) {
  ScratchFolder scratch;
  const std::string folder = (scratch / "run").string();
  const std::string range = " --parameter forcing.frequency --from 2.3 --to 2.8 ";
  const Finished first = run_graze("continue --json --out " + folder + range +
                                   "--set forcing.frequency=2.4 " + kDashpotOscillator);
  ASSERT_EQ(first.code, 0) << first.err;
  const Finished doubled = run_graze("continue --json " + folder + "/scene.toml --restart " +
                                     folder + " --label PD1 --switch" + range);
  ASSERT_EQ(doubled.code, 0) << doubled.err;
  const json branches = json::parse(doubled.out)["branches"];
  ASSERT_EQ(branches.size(), 1u);
  EXPECT_EQ(branches[0]["period"], 2);
  const Finished same = run_graze("continue --json " + folder + "/scene.toml --restart " + folder +
                                  " --label PD1" + range);
  ASSERT_EQ(same.code, 0) << same.err;
  const json again = json::parse(same.out)["branches"];
  ASSERT_EQ(again.size(), 1u);
  EXPECT_EQ(again[0]["period"], 1);
  bool passes = false;
  for (const json& special : again[0]["special"]) passes = passes || special["label"] == "PD";
  EXPECT_TRUE(passes);
}

TEST(CompliantOrbits, ShareThePlaneWithOtherMotions) {
  const Finished run = run_graze(
      "continue --json --start closed-form --locus GR --slices 1 --regions 2 --parameter stop.gap "
      "--from 0.2 --to 0.4 --second forcing.frequency --second-from 2.3 --second-to 2.5 " +
      kDashpotOscillator);
  ASSERT_EQ(run.code, 0) << run.err;
  const json places = json::parse(run.out)["regions"]["places"];
  ASSERT_EQ(places.size(), 4u);
  // The gaps are 0.25 and 0.35 m, the largest response at 2.35 rad/s 0.22 m.
  for (const json& place : places)
    EXPECT_NE(place["label"].get<std::string>().find("no impact"), std::string::npos) << place;
}

// The locus of a grazing without other contacts: the gap is the amplitude of the linear response.
TEST(CompliantOrbits, GoOnAlongTheLociOfTheirSpecialPoints) {
  ScratchFolder scratch;
  const std::string folder = (scratch / "run").string();
  const std::string range = " --parameter stop.gap --from 0.05 --to 0.3 ";
  const Finished first = run_graze("continue --json --start closed-form --out " + folder + range +
                                   "--set forcing.frequency=2.4 " + kDashpotOscillator);
  ASSERT_EQ(first.code, 0) << first.err;
  const std::string from = "continue --json " + folder + "/scene.toml --restart " + folder + range +
                           "--second forcing.frequency --second-from 2.3 --second-to 2.5 ";
  for (const std::string kind : {"GR", "PD"}) {
    const Finished run = run_graze(from + "--label " + kind + "1 --locus " + kind);
    ASSERT_EQ(run.code, 0) << run.err;
    const json loci = json::parse(run.out)["loci"];
    ASSERT_EQ(loci.size(), 1u);
    EXPECT_EQ(loci[0]["label"], kind);
    EXPECT_EQ(loci[0]["impacts"], 1);
    double nearest = 1.0;
    for (const json& point : loci[0]["points"]) {
      const double w = point["second"].get<double>(), gap = point["value"].get<double>();
      if (kind == "GR") {
        EXPECT_NEAR(gap, 1.0 / std::hypot(1.0 - w * w, 0.1 * w), 1e-11) << w;
      }
      nearest = std::min(nearest, std::abs(w - 2.4));
    }
    EXPECT_LT(nearest, 0.01);
  }
  const Finished other = run_graze(from + "--label GR1 --locus PD");
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.err.find("GR1 lies on a locus of GR"), std::string::npos) << other.err;
}

// A point of a branch tells how short the contacts of its orbit are; the simulation that starts on
// the orbit tells how long they are.
TEST(CompliantBranch, TellsItsShortestContact) {
  const ScratchFolder scratch;
  const std::string oscillator = scene("12_spring_dashpot_oscillator.toml");
  const Finished run = run_graze("continue " + oscillator +
                                 " --impacts 1 --parameter forcing.frequency --from 2.5 --to 3.2 "
                                 "--json --out " +
                                 scratch.string());
  ASSERT_EQ(run.code, 0) << run.err;
  const json branch = json::parse(run.out)["branches"][0];
  const std::size_t middle = branch["points"].size() / 2;
  const json& point = branch["points"][middle];
  const std::string frequency =
      " --set forcing.frequency=" + point["value"].dump() + " " + oscillator;
  const json orbit =
      json::parse(run_graze("orbit --json --impacts 1" + frequency).out)["orbits"][0];
  const json& start = orbit["section"];
  const json motion = json::parse(
      run_graze("simulate --json --periods 1 --set forcing.phase=" + start["phase"].dump() +
                " --set 'initial.q=" + start["q"].dump() +
                "' --set 'initial.qdot=" + start["qdot"].dump() + "'" + frequency)
          .out);
  ASSERT_EQ(motion["events"].size(), 2U);
  EXPECT_NEAR(point["shortest_contact"].get<double>(),
              motion["events"][1]["duration"].get<double>(), 1e-10);
  const std::vector<std::string> rows = lines_of(scratch.string() + "/branches.csv");
  const std::vector<std::string> names = support::split_cells(rows[0]);
  const auto column = std::find(names.begin(), names.end(), "shortest_contact") - names.begin();
  ASSERT_LT(static_cast<std::size_t>(column), names.size());
  const std::vector<std::string> cells = support::split_cells(rows[1 + middle]);
  EXPECT_EQ(std::stod(cells[static_cast<std::size_t>(column)]), point["shortest_contact"]);
}

}  // namespace
}  // namespace graze
