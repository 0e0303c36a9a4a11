// graze diagram: what it prints, writes and draws, and how it ends.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "apps/program.hpp"

namespace graze {
namespace {

using nlohmann::json;

// The oscillator of hard case G2: both clear of the stop and impacting between fold and grazing.
const std::string kBistable =
    kOscillator + " --set forcing.frequency=1.6 --set stop.gap=0.5 --set 'initial.q=[0.0]'" +
    " --parameter forcing.amplitude --from 0.2 --to 1 --points 41 ";

json diagram(const std::string& arguments, int code = 0) {
  const Finished run = run_graze("diagram --json " + arguments);
  EXPECT_EQ(run.code, code) << run.err;
  return json::parse(run.out);
}

TEST(Diagram, HasSweepAndBranchesInOneDocument) {
  const json document = diagram(kBistable + "--direction down");
  EXPECT_EQ(document["outcome"], "complete");
  EXPECT_EQ(document["parameter"], "forcing.amplitude");
  EXPECT_EQ(document["graze"]["options"]["direction"], "down");
  EXPECT_GE(document["branches"].size(), 1U);
  const json& sweep = document["sweep"];
  EXPECT_EQ(sweep["section"], "impact");
  EXPECT_EQ(sweep["direction"], "down");
  ASSERT_EQ(sweep["rows"].size(), 41U);
  for (const json& row : sweep["rows"])
    for (const char* key : {"value", "start", "status", "attractor", "period", "impacts", "sticks",
                            "periods", "remaining", "stops", "phases", "speeds"})
      EXPECT_TRUE(row.contains(key)) << key;
  // Fold at .2766517..., so 0.26 is clear and 0.28 is not.
  ASSERT_EQ(sweep["ranges"].size(), 2U);
  EXPECT_EQ(sweep["ranges"][0]["attractor"], "clear");
  EXPECT_NEAR(sweep["ranges"][0]["to"].get<double>(), 0.26, 1e-12);
  EXPECT_EQ(sweep["ranges"][1]["attractor"], "(1,1)");
  EXPECT_NEAR(sweep["ranges"][1]["from"].get<double>(), 0.28, 1e-12);
  EXPECT_EQ(sweep["ranges"][1]["values"], 37);
}

TEST(Diagram, DotsLieOnTheStableBranch) {
  const json document = diagram(kBistable + "--direction down");
  const json& last = document["sweep"]["rows"].back();
  double nearest = 1.0;
  for (const json& branch : document["branches"])
    for (const json& point : branch["points"])
      if (point["value"] == 1.0 && point["stable"] == true)
        nearest = std::min(
            nearest, std::abs(point["speed"].get<double>() - last["speeds"][0].get<double>()));
  EXPECT_LE(nearest, 1e-8);
}

// From 82.5 to 107 rad/s the beam hits its stop once in two periods (docs/diagram.md).
const std::string kTwoPeriods =
    kOneMode + " --parameter forcing.frequency --from 86 --to 104 --json ";

std::set<std::pair<int, int>> orbits_of(const json& branches) {
  std::set<std::pair<int, int>> kinds;
  for (const json& branch : branches)
    kinds.emplace(branch["period"].get<int>(), branch["impacts"].get<int>());
  return kinds;
}

TEST(Diagram, BranchesFollowWhatTheSweepSettlesOn) {
  const json document = diagram(kTwoPeriods + "--points 19");
  EXPECT_EQ(document["graze"]["options"]["branches"], "found");
  EXPECT_TRUE(orbits_of(document["branches"]).contains({2, 1})) << document["branches"].size();
  // Dots and branch meet in the middle of the range, where the branch was begun.
  const json& middle = document["sweep"]["rows"][9];
  ASSERT_EQ(middle["attractor"], "(2,1)");
  double nearest = 1.0;
  for (const json& branch : document["branches"])
    for (const json& point : branch["points"])
      if (branch["period"] == 2 && point["value"] == middle["value"])
        nearest = std::min(
            nearest, std::abs(point["speed"].get<double>() - middle["speeds"][0].get<double>()));
  EXPECT_LE(nearest, 1e-8);
  // Who names orbits has those alone.
  const json named = diagram(kTwoPeriods + "--points 3 --impacts 1");
  EXPECT_EQ(named["graze"]["options"]["branches"], "all");
  EXPECT_FALSE(orbits_of(named["branches"]).contains({2, 1}));
  for (const char* wrong : {"--branches found --period 2", "--branches found --impacts 1",
                            "--branches all --impacts any", "--impacts 65", "--impacts some"})
    EXPECT_EQ(run_graze("diagram " + kTwoPeriods + wrong).code, 2) << wrong;
}

TEST(Continue, AnyImpactsAreWhatMotionsSettleOn) {
  const Finished run = run_graze("continue " + kTwoPeriods + "--impacts any");
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["graze"]["options"]["impacts"], "any");
  EXPECT_TRUE(orbits_of(document["branches"]).contains({2, 1}));
  EXPECT_EQ(run_graze("continue " + kTwoPeriods + "--impacts any --period 2").code, 2);
}

TEST(Diagram, GivesTheSameBytesForAnyNumberOfThreads) {
  for (const char* direction : {"up", "down", "fresh"}) {
    const std::string line = "diagram --json " + kOneMode +
                             " --parameter forcing.frequency --from 55 --to 70 --points 70"
                             " --periods 150 --branches none --direction " +
                             direction + " --threads ";
    const std::string one = run_graze(line + "1").out;
    EXPECT_GT(one.size(), 1000U);
    EXPECT_EQ(run_graze(line + "2").out, one);
    EXPECT_EQ(run_graze(line + "5").out, one);
  }
}

TEST(Diagram, WritesItsTablesWhole) {
  const ScratchFolder scratch;
  for (const char* section : {"impact", "stroboscopic"}) {
    const std::string folder = (scratch / section).string();
    const Finished run = run_graze("diagram " + kBistable + "--section " + section +
                                   " --direction down --out " + folder);
    EXPECT_EQ(run.code, 0) << run.err;
    const std::vector<std::string> names = {"branches.csv", "record.json", "result.json",
                                            "rows.journal", "scene.toml",  "special.csv",
                                            "sweep.csv"};
    EXPECT_EQ(names_in(folder), names);
    const std::vector<std::string> lines = lines_of(folder + "/sweep.csv");
    EXPECT_EQ(lines.front(),
              "value,start,status,attractor,period,impacts,periods,remaining,sample,stop,"
              "period_index,phase,speed,displacement,velocity");
    ASSERT_EQ(lines.size(), 42U);  // one impact or one state a value; a clear one has its line too
    for (const std::string& line : lines)
      EXPECT_EQ(std::count(line.begin(), line.end(), ','), 14) << line;
  }
}

TEST(Diagram, PrintsRangesOfAttractors) {
  const Finished run = run_graze("diagram " + kBistable + "--direction down --branches none");
  EXPECT_EQ(run.code, 0);
  EXPECT_NE(run.out.find("settles on"), std::string::npos);
  EXPECT_NE(run.out.find("(1,1)"), std::string::npos);
  EXPECT_NE(run.out.find("no impact"), std::string::npos);
  EXPECT_EQ(run.err, "");
}

TEST(Diagram, DrawsInEveryFormatAndKeepsThemSmall) {
  const ScratchFolder scratch;
  for (const char* format : {"png", "svg", "pdf"}) {
    const std::string file = (scratch / (std::string("d.") + format)).string();
    // Fifteen thousand dots of a motion that never repeats, and both directions' branches.
    const Finished run = run_graze("diagram " + kOscillator +
                                   " --parameter forcing.frequency --from 2.74 --to 2.9 --points 60"
                                   " --periods 400 --samples 250 --plot " +
                                   file);
    EXPECT_EQ(run.code, 0) << run.err;
    const std::string picture = read_text(file);
    EXPECT_GT(picture.size(), 10'000U) << format;
    EXPECT_LT(picture.size(), 1'000'000U) << format;
    EXPECT_TRUE(std::filesystem::exists(scratch / "d.gp"));
    if (std::string(format) != "svg") continue;
    EXPECT_NE(picture.find("data:image/png;base64"), std::string::npos);
    // Axes and words are no pixels; each kind stands in the legend once.
    EXPECT_NE(picture.find(">impact speed (m/s)<"), std::string::npos);
    const std::string entry = ">unstable</tspan>";
    const std::size_t first = picture.find(entry);
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(picture.find(entry, first + 1), std::string::npos);
    EXPECT_EQ(names_in(scratch.string()),
              (std::vector<std::string>{"d.gp", "d.gp.dat", "d.png", "d.svg"}));
  }
}

TEST(Diagram, ASpentBudgetEndsWith3AndKeepsAllRows) {
  const json document = diagram(kBistable + "--max-impacts 3 --branches none", 3);
  EXPECT_EQ(document["outcome"], "budget");
  EXPECT_FALSE(document["message"].get<std::string>().empty());
  const json& rows = document["sweep"]["rows"];
  ASSERT_EQ(rows.size(), 41U);
  EXPECT_EQ(rows[0]["status"], "settled");
  EXPECT_EQ(rows[40]["status"], "impact budget");
  EXPECT_TRUE(rows[40]["message"].is_string());
}

TEST(Diagram, OutOfTimeKeepsWhatIsFinished) {
  const json document = diagram(kOneMode +
                                    " --parameter forcing.frequency --from 60 --to 66 --points "
                                    "100000 --branches none --max-seconds 2",
                                3);
  EXPECT_EQ(document["outcome"], "budget");
  EXPECT_GT(document["sweep"]["rows"].size(), 0U);
  EXPECT_LT(document["sweep"]["rows"].size(), 100000U);
}

TEST(Diagram, AnInterruptKeepsWhatIsFinished) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "out").string();
  const Finished run = run_graze("diagram " + kOneMode +
                                     " --parameter forcing.frequency --from 60 --to 66 --points "
                                     "200000 --branches none --out " +
                                     folder,
                                 "timeout -s INT 2 ");
  EXPECT_NE(run.code, 0);
  const json document = json::parse(read_text(folder + "/result.json"));
  EXPECT_EQ(document["outcome"], "interrupted");
  EXPECT_GT(document["sweep"]["rows"].size(), 0U);
  const std::vector<std::string> lines = lines_of(folder + "/sweep.csv");
  EXPECT_GT(lines.size(), document["sweep"]["rows"].size());
}

// One mode between two stops: the motion hits them in turn, and that is the branch drawn over it.
TEST(Diagram, SweepsSeveralStopsWithTheirBranches) {
  const json document = diagram(scene("07_two_stops.toml") +
                                " --set beam.modes=1 --parameter forcing.frequency --from 27 --to "
                                "29 --points 5 --periods 60 --impacts 2");
  EXPECT_EQ(document["outcome"], "complete");
  std::set<int> stops;
  for (const json& row : document["sweep"]["rows"])
    for (const int stop : row["stops"]) stops.insert(stop);
  EXPECT_EQ(stops, (std::set<int>{1, 2}));
  bool in_turn = false;
  for (const json& branch : document["branches"])
    in_turn = in_turn || branch["stops"] == json::array({1, 2});
  EXPECT_TRUE(in_turn);
}

// One place with stops on both sides has one panel, a second place its own.
TEST(Diagram, StroboscopicStatesHaveAPanelForEveryPlaceWithStops) {
  const ScratchFolder scratch;
  const std::string line = "diagram " + scene("07_two_stops.toml") +
                           " --set beam.modes=2 --parameter forcing.frequency --from 27 --to 29"
                           " --points 5 --periods 60 --impacts 2 --section stroboscopic";
  const auto picture = [&](const std::string& more, const std::string& name) {
    const Finished run = run_graze(line + more + " --plot " + (scratch / name).string());
    EXPECT_EQ(run.code, 0) << run.err;
    return read_text(scratch / name);
  };
  const std::string apart = " --set stop.2.position=0.2";
  picture(apart, "x.svg");
  picture(apart + " --branches none", "x.png");
  const std::string two = read_text(scratch / "x.svg"), one = picture("", "y.svg");
  EXPECT_NE(two.find(">towards stop 1 (mm)<"), std::string::npos);
  EXPECT_NE(two.find(">towards stop 2 (mm)<"), std::string::npos);
  EXPECT_NE(one.find("towards stop 1 (mm)<"), std::string::npos);
  EXPECT_EQ(one.find("towards stop 2 (mm)<"), std::string::npos);
}

TEST(Diagram, UsageErrorsExitWith2) {
  const std::string range = " --parameter stop.gap --from 0 --to 1e-3 ";
  for (const std::string& line : std::vector<std::string>{
           kOneMode, kOneMode + " --parameter nope --from 0 --to 1",
           kOneMode + " --parameter stop.gap --from 1 --to 1",
           kOneMode + " --parameter beam.length --from -1 --to 1", kOneMode + range + "--points 1",
           kOneMode + range + "--direction sideways", kOneMode + range + "--section poincare",
           kOneMode + range + "--periods 0", kOneMode + range + "--samples 0",
           kOneMode + range + "--branches some", kOneMode + range + "--plot x.gif",
           scene("06_bouncing_ball.toml") + " --parameter stop.gap --from 1 --to 2"}) {
    const Finished run = run_graze("diagram " + line);
    EXPECT_EQ(run.code, 2) << line;
    EXPECT_EQ(run.out, "") << line;
    EXPECT_NE(run.err, "") << line;
  }
}

// Of orbits they are what their multipliers say, of a motion that stays clear the rate of decay.
TEST(Diagram, TellsExponents) {
  const ScratchFolder out;
  const json document = diagram(kBistable + "--direction down --exponents 100 --out " +
                                (out / "run").string() + " --plot " + (out / "d.svg").string());
  EXPECT_EQ(document["graze"]["options"]["exponents"], 100);
  EXPECT_EQ(document["units"]["exponents"], "1/s");
  const double period = 2.0 * M_PI / 1.6, delta = 0.05;
  for (const json& row : document["sweep"]["rows"]) {
    const json& exponents = row["exponents"];
    ASSERT_EQ(exponents.size(), 2U);
    EXPECT_EQ(row["lost_exponents"], 0);
    const double sum = exponents[0].get<double>() + exponents[1].get<double>();
    const double impacts = row["attractor"] == "clear" ? 0.0 : 1.0;
    EXPECT_NEAR(sum, -2.0 * delta + impacts * 2.0 * std::log(0.8) / period, 1e-8);
    EXPECT_LT(exponents[0].get<double>(), 0.0);
  }
  std::istringstream table(read_text(out / "run" / "exponents.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line, "value,period,periods,impacts,lost,exponent_1,exponent_2,error_1,error_2");
  EXPECT_NE(read_text(out / "d.svg").find("exponent"), std::string::npos);
  EXPECT_FALSE(diagram(kBistable)["sweep"]["rows"][0].contains("exponents"));
}

}  // namespace
}  // namespace graze
