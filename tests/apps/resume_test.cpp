// A run that is cut and resumed is, byte for byte, the run that was never cut.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace graze {
namespace {

using nlohmann::json;

// Runs of one scene in folders of their own, with all that can be recorded.
class Runs {
 public:
  explicit Runs(const std::string& scene) : scene_(scene) {}

  void run(const std::string& name, const std::string& options, int code = 0) {
    const Finished run = run_graze("simulate --record samples --energy --quiet --out " +
                                   folder(name) + " " + options + " " + scene_);
    EXPECT_EQ(run.code, code) << run.err;
  }
  std::string folder(const std::string& name) const { return (scratch_ / name).string(); }
  std::vector<std::string> table(const std::string& name, const char* file) const {
    return lines_of(folder(name) + "/" + file);
  }
  json document(const std::string& name) const {
    return json::parse(read_text(folder(name) + "/result.json"));
  }

 private:
  ScratchFolder scratch_;
  std::string scene_;
};

// The first table, and what the second adds to it.
std::vector<std::string> joined(std::vector<std::string> first,
                                const std::vector<std::string>& second) {
  EXPECT_EQ(first.at(0), second.at(0));
  first.insert(first.end(), second.begin() + 1, second.end());
  return first;
}

void expect_same(const Runs& runs, const std::string& whole, const std::string& first,
                 const std::string& second) {
  for (const char* file : {"events.csv", "samples.csv"})
    EXPECT_TRUE(joined(runs.table(first, file), runs.table(second, file)) ==
                runs.table(whole, file))
        << file;
  const json a = runs.document(whole), b = runs.document(second);
  EXPECT_EQ(a["outcome"], b["outcome"]);
  EXPECT_EQ(a["final"].dump(), b["final"].dump());
  EXPECT_EQ(a["energy"].dump(), b["energy"].dump());
  EXPECT_EQ(a["totals"].dump(), b["totals"].dump());
}

TEST(Resume, GoesOnByteForByteFromAnyTime) {
  struct Case {
    std::string scene, end;
    std::vector<std::string> cuts;
  };
  const std::vector<Case> cases = {
      // From rest; within flights; in the first chatter; between a chatter's last impact and its
      // stick (0.5412894499597 s, 0.5412894544763 s); held; right after the release.
      {"02_wagg_momentum.toml",
       "2",
       {"0", "0.1", "0.3", "0.541", "0.541289452", "0.542", "0.543452796", "1", "1.9999", "2"}},
      // In flight, in the summed tail, at rest.
      {"06_bouncing_ball.toml", "5", {"0.2", "2", "4.0637110", "4.5"}},
      {"07_two_stops.toml", "1", {"0.217", "0.4444", "0.8"}},
      {"08_preloaded_oscillator.toml", "30", {"2", "4.61", "12", "20"}},
      // Before, within and after contacts on springs.
      {"12_spring_dashpot_oscillator.toml", "20", {"1", "2.5", "3", "3.5", "10"}},
      {"14_beam_against_a_ball.toml", "0.2", {"0.05", "0.1", "0.11", "0.15"}}};
  for (const Case& c : cases) {
    Runs runs(scene(c.scene));
    runs.run("whole", "--duration " + c.end);
    for (std::size_t i = 0; i < c.cuts.size(); ++i) {
      SCOPED_TRACE(c.scene + " cut at " + c.cuts[i]);
      const std::string first = "first" + std::to_string(i), second = "second" + std::to_string(i);
      runs.run(first, "--duration " + c.cuts[i]);
      runs.run(second, "--duration " + c.end + " --resume " + runs.folder(first));
      expect_same(runs, "whole", first, second);
    }
  }
}

TEST(Resume, GoesOnAfterARunThatWasStopped) {
  for (const char* name : {"02_wagg_momentum.toml", "07_two_stops.toml"}) {
    Runs runs(scene(name));
    runs.run("whole", "--duration 1");
    for (const char* impacts : {"1", "2", "13", "20"}) {
      SCOPED_TRACE(std::string(name) + " after impact " + impacts);
      const std::string first = "first" + std::string(impacts), second = first + "on";
      runs.run(first, "--duration 1 --max-impacts " + std::string(impacts), 3);
      runs.run(second, "--duration 1 --resume " + runs.folder(first) + "/record.json");
      expect_same(runs, "whole", first, second);
    }
  }
}

TEST(Resume, IsNamedByARunThatWasStopped) {
  const ScratchFolder scratch;
  const std::string run = (scratch / "run").string();
  const Finished cut = run_graze(
      "simulate --json --duration 1e6 --record none --max-seconds 1e-3 "
      "--set stop.restitution=0.9 --out " +
      run + "/ " + kMomentum);
  const std::string told = json::parse(cut.out)["message"];
  EXPECT_NE(told.find("--resume " + run + "/ --out " + run + "-on"), std::string::npos) << told;
  const std::size_t at = told.find("to go on: graze ");
  ASSERT_NE(at, std::string::npos) << told;
  EXPECT_EQ(run_graze(told.substr(at + 16)).code, 3);
  EXPECT_TRUE(std::filesystem::exists(run + "-on/result.json"));
}

// Before its first arc is over the gap still departs from a zero of order four.
TEST(Resume, GoesOnFromAStartThatBalances) {
  Runs runs(
      "--set 'modal.damping_ratios=[0.0]' --set forcing.frequency=1.5 --set stop.gap=1 "
      "--set forcing.amplitude=1 --set 'initial.q=[1.0]' " +
      scene("04_impact_oscillator.toml"));
  runs.run("whole", "--duration 10");
  runs.run("first", "--duration 1");
  runs.run("second", "--duration 10 --resume " + runs.folder("first"));
  expect_same(runs, "whole", "first", "second");
}

TEST(Resume, GoesOnSeveralTimes) {
  Runs runs(kMomentum);
  runs.run("whole", "--duration 1.5");
  runs.run("1", "--duration 0.4");
  runs.run("2", "--duration 0.9 --resume " + runs.folder("1"));
  runs.run("3", "--duration 1.5 --resume " + runs.folder("2"));
  for (const char* file : {"events.csv", "samples.csv"})
    EXPECT_TRUE(joined(joined(runs.table("1", file), runs.table("2", file)),
                       runs.table("3", file)) == runs.table("whole", file))
        << file;
  EXPECT_EQ(runs.document("3")["final"].dump(), runs.document("whole")["final"].dump());
  EXPECT_EQ(runs.document("3")["totals"].dump(), runs.document("whole")["totals"].dump());
  EXPECT_EQ(runs.document("3")["graze"]["options"]["resume_time"], 0.9);
}

// A picture wants more samples than the table has, which must not move those of the table.
TEST(Resume, GoesOnWithAPictureAndWithout) {
  Runs runs(kMomentum);
  const std::string plot = "--plot " + runs.folder("motion.svg") + " ";
  runs.run("whole", "--duration 1");
  runs.run("drawn", plot + "--duration 0.5");
  runs.run("bare", "--duration 0.5");
  EXPECT_EQ(runs.table("drawn", "samples.csv"), runs.table("bare", "samples.csv"));
  for (const char* first : {"drawn", "bare"})
    for (const std::string& second : {std::string(), plot}) {
      runs.run("second", second + "--duration 1 --resume " + runs.folder(first));
      EXPECT_TRUE(joined(runs.table(first, "samples.csv"), runs.table("second", "samples.csv")) ==
                  runs.table("whole", "samples.csv"))
          << first << " " << second;
    }
}

TEST(Resume, SamplesStartWhereThereWereNone) {
  const ScratchFolder scratch;
  const std::string first = (scratch / "first").string(), second = (scratch / "second").string();
  ASSERT_EQ(run_graze("simulate --duration 1.01 --out " + first + " " + kBall).code, 0);
  ASSERT_EQ(run_graze("simulate --duration 2 --record samples --sample-rate 50 --energy --resume " +
                      first + " --out " + second + " " + kBall)
                .code,
            0);
  const std::vector<std::string> samples = lines_of(second + "/samples.csv");
  ASSERT_EQ(samples.size(), 51U);  // 1.02, 1.04, .., 2
  EXPECT_EQ(samples[1].substr(0, 5), "1.02,");
  EXPECT_EQ(samples.back().substr(0, 2), "2,");
  // The energy balance could only begin at the cut, and closes from there.
  const json document = json::parse(read_text(second + "/result.json"));
  EXPECT_NE(document["notes"].dump().find("energy balance"), std::string::npos);
  EXPECT_LE(document["energy"]["relative_defect"], 1e-12);
  EXPECT_GT(document["energy"]["start"], 0.0);
}

TEST(Resume, ClosureSpeedIsTheFirstRunsUnlessGiven) {
  const ScratchFolder scratch;
  const std::string first = (scratch / "first").string();
  ASSERT_EQ(
      run_graze("simulate --duration 1 --closure-speed 0.01 --out " + first + " " + kBall).code, 0);
  const auto closure_of = [&](const std::string& options) {
    const json document = json::parse(
        run_graze("simulate --json --duration 5 --resume " + first + " " + options + kBall).out);
    for (const json& event : document["events"])
      if (event["kind"] == "chatter") return event["closure_speed"].get<double>();
    return -1.0;
  };
  EXPECT_EQ(closure_of(""), 0.01);
  EXPECT_EQ(closure_of("--closure-speed 0.05 "), 0.05);
}

TEST(Resume, SaysWhyItCannot) {
  const ScratchFolder scratch;
  const std::string run = (scratch / "run").string();
  ASSERT_EQ(run_graze("simulate --duration 1 --out " + run + " " + kBall).code, 0);
  const std::string before = read_text(run + "/result.json");
  const auto refused = [&](const std::string& arguments, int code, const std::string& words) {
    const Finished finished = run_graze("simulate --json " + arguments);
    EXPECT_EQ(finished.code, code) << arguments;
    EXPECT_EQ(finished.out, "");
    EXPECT_NE(finished.err.find(words), std::string::npos) << finished.err;
  };
  const std::string from = "--resume " + run + " ";
  refused(from + "--duration 0.5 " + kBall, 2, "t = 0.5 s, lies before t = 1 s");
  refused(from + "--duration 2 --set stop.gap=0.9 " + kBall, 2,
          "the run in " + run + " is of another scene");
  refused(from + "--duration 2 --out " + run + " " + kBall, 2, "give another folder");
  refused("--resume " + run + "/scene.toml --duration 2 " + kBall, 4, "record.json");
  refused("--resume " + scratch.string() + " --duration 2 " + kBall, 4, "record.json");
  refused("--resume no/such/file --duration 2 " + kBall, 4, "there is no such folder");
  const std::string orbits = (scratch / "orbits").string();
  ASSERT_EQ(run_graze("orbit --out " + orbits + " " + kOneMode).code, 0);
  refused("--resume " + orbits + " --duration 2 " + kBall, 2, "holds no run of graze simulate");
  EXPECT_EQ(read_text(run + "/result.json"), before);
  // The scene in force is what counts, not the file that it came from.
  EXPECT_EQ(run_graze("simulate " + from + "--duration 2 " + run + "/scene.toml").code, 0);
}

}  // namespace
}  // namespace graze
