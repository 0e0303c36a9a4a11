// graze view: results printed and drawn from their folders.
#include <gtest/gtest.h>

#include <cstdint>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace graze {
namespace {

using nlohmann::json;

struct Drawn {
  const char* name;
  std::string line;  // of the command
  const char* picture = "p.svg";
  const char* asked = "";  // of the picture
};

void PrintTo(const Drawn& drawn, std::ostream* stream) { *stream << drawn.name; }

const std::string kViewedSweep =
    "diagram --parameter forcing.frequency --from 58 --to 62 --points 9 --periods 300 --samples "
    "20 ";
const std::string kViewedPlane =
    " --parameter forcing.frequency --from 50 --to 60 --points 5 --second stop.gap "
    "--second-from 0.5e-3 --second-to 2e-3 --second-points 4 ";

std::vector<Drawn> all_drawn() {
  const std::string beam = scene("02_wagg_momentum.toml"), ball = scene("06_bouncing_ball.toml");
  const std::string branch =
      " --parameter forcing.frequency --from 58 --to 62 --max-step 0.5 " + kOneMode;
  const std::string plane =
      "continue --locus LP,GR --parameter forcing.frequency --from 50 --to 60 --second stop.gap "
      "--second-from 1e-3 --second-to 1.2e-3 --slices 2 --regions 3 " +
      kOneMode;
  return {
      {"check", "check " + beam},
      {"check_page", "check " + beam, "p.html"},
      {"returns", "simulate --periods 60 --section impact --show returns " + beam},
      {"spectrum", "simulate --periods 70 --show spectrum " + beam},
      {"shapes", "simulate --periods 5 --shapes-at 0.1,0.2 --show shapes " + beam},
      {"forces", "simulate --periods 5 --show forces " + beam},
      {"simulate", "simulate --periods 30 --amplitudes " + beam},
      {"simulate_samples", "simulate --periods 5 --record samples --energy " + beam},
      {"simulate_page", "simulate --periods 30 " + scene("16_strain_gauge.toml"), "p.html"},
      {"simulate_hub", "simulate --duration 0.3 " + scene("19_yigit_momentum.toml")},
      {"simulate_compliant", "simulate --periods 5 " + scene("09_soft_stop_two_modes.toml")},
      {"section", "simulate --periods 60 --section impact " + beam},
      {"section_stroboscopic", "simulate --periods 60 --section stroboscopic " + beam},
      {"orbit", "orbit --set forcing.frequency=40 " + kOneMode},
      {"orbit_page", "orbit --set forcing.frequency=40 " + kOneMode, "p.html"},
      {"orbit_compliant", "orbit " + scene("12_spring_dashpot_oscillator.toml"), "p.html"},
      {"continue", "continue" + branch},
      {"continue_page", "continue" + branch, "p.html"},
      {"continue_asked", "continue" + branch, "p.svg",
       " --title 'A title' --style slide --labels none --multipliers --y-scale log --x-range "
       "59:61"},
      {"response", "continue --show rms --at stop.1" + branch},
      {"loci", plane},
      {"loci_page", plane, "p.html"},
      {"diagram", kViewedSweep + kOneMode},
      {"diagram_page", kViewedSweep + "--exponents 30 " + kOneMode, "p.html"},
      {"diagram_stroboscopic", kViewedSweep + "--section stroboscopic " + kOneMode},
      {"diagram_response", kViewedSweep + "--show peak-velocity --branches none " + kOneMode},
      {"diagram_of_runs",
       "diagram --duration 1.8 --points 7 --parameter stop.gap --from 0.5 --to 2 " + ball},
      {"map", "map --show speed --periods 200" + kViewedPlane + kOneMode},
      {"map_measured", "map --show rms --at stop.1 --periods 200" + kViewedPlane + kOneMode},
      {"map_page", "map --locus GR --slices 2 --periods 200" + kViewedPlane + kOneMode, "p.html"},
      {"basins",
       "map --periods 200 --parameter initial.q.1 --from -1e-5 --to 1e-5 --points 4 --second "
       "initial.qdot.1 --second-from -1e-4 --second-to 1e-4 --second-points 3 " +
           kOneMode},
      {"compare", "compare --periods 200 --against beam.modes=2 " + kOneMode},
      {"compare_modes", "compare --periods 200 --modes 1:3 " + beam},
      {"compare_map",
       "compare --periods 200 --against stop.restitution=0.7" + kViewedPlane + kOneMode},
      {"sensitivity",
       "compare --sensitivity --parameter hub.torque.amplitude --from 0.1 --to 0.2 --points 3 "
       "--duration 0.05 " +
           scene("20_yigit_sensitivity.toml")},
      {"cost", "cost --impacts 3 " + kOneMode},
      {"compare_map_page",
       "compare --periods 200 --against stop.restitution=0.7" + kViewedPlane + kOneMode, "p.html"},
      {"fit_page", "fit " + measured("restitution.toml") + " " + measured("restitution.csv"),
       "p.html"},
      {"fit", "fit " + measured("restitution.toml") + " " + measured("restitution.csv")},
  };
}

class View : public testing::TestWithParam<Drawn> {};

// Two pictures have one script where they have one name.
TEST_P(View, ShowsWhatTheCommandShowed) {
  const Drawn& drawn = GetParam();
  const ScratchFolder scratch;
  const std::string run = (scratch / "run").string();
  for (const char* folder : {"once", "again", "third"})
    std::filesystem::create_directory(scratch / folder);
  const std::string once = (scratch / "once" / drawn.picture).string();
  const std::string again = (scratch / "again" / drawn.picture).string();
  const Finished made = run_graze(drawn.line + " --out " + run + " --plot " + once + drawn.asked);
  if (made.err.find("built without npm") != std::string::npos) GTEST_SKIP() << made.err;
  ASSERT_TRUE(made.code == 0 || made.code == 3) << made.err;
  const std::vector<std::string> names = names_in(run);

  const Finished seen = run_graze("view " + run + " --plot " + again + drawn.asked);
  ASSERT_EQ(seen.code, 0) << seen.err;
  EXPECT_EQ(seen.out, made.out);
  EXPECT_EQ(seen.err, made.err);
  EXPECT_EQ(names_in(scratch / "again"), names_in(scratch / "once"));
  for (const std::string& name : names_in(scratch / "once"))
    EXPECT_EQ(read_text(scratch / "again" / name), read_text(scratch / "once" / name)) << name;
  EXPECT_EQ(names_in(run), names);

  const Finished document = run_graze("view --json " + run + "/result.json");
  EXPECT_EQ(document.code, 0) << document.err;
  EXPECT_EQ(document.out, read_text(run + "/result.json"));
}

INSTANTIATE_TEST_SUITE_P(Results, View, testing::ValuesIn(all_drawn()),
                         [](const auto& named) { return std::string(named.param.name); });

// A folder with a result that is made in no time.
class ViewedFolder : public testing::Test {
 protected:
  void SetUp() override {
    const Finished made =
        run_graze("orbit --set forcing.frequency=40 --out " + run_ + " " + kOneMode);
    ASSERT_EQ(made.code, 0) << made.err;
  }
  // That nothing is printed or written is part of a refusal.
  void expect_refused(int code, const std::string& file, const std::string& why,
                      const std::string& options = "") {
    const Finished run = run_graze("view " + run_ + " --plot " + plot_ + options);
    EXPECT_EQ(run.code, code) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err.rfind(file, 0), 0u) << run.err;
    EXPECT_NE(run.err.find(why), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(plot_));
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(std::filesystem::path(run_) / name, std::ios::binary) << text;
  }
  std::string read(const std::string& name) { return read_text(run_ + "/" + name); }

  ScratchFolder scratch_;
  std::string run_ = (scratch_ / "run").string(), plot_ = (scratch_ / "p.svg").string();
};

TEST_F(ViewedFolder, IsRefusedWithoutItsFiles) {
  run_ = (scratch_ / "none").string();
  expect_refused(4, run_, "no such folder");
  run_ = (scratch_ / "run").string();
  for (const char* name : {"record.json", "scene.toml"}) {
    const std::string text = read(name);
    std::filesystem::remove(std::filesystem::path(run_) / name);
    expect_refused(4, run_ + "/" + name, name == std::string("record.json") ? "missing" : "cannot");
    write(name, text);
  }
  const std::string document = read("result.json");
  std::filesystem::remove(std::filesystem::path(run_) / "result.json");
  expect_refused(4, run_ + "/result.json", "cannot read", " --json");
  write("result.json", document);
  EXPECT_EQ(run_graze("view " + run_).code, 0);
}

TEST_F(ViewedFolder, IsRefusedWhereAFileIsCutShort) {
  for (const char* name : {"record.json", "scene.toml", "result.json"}) {
    const std::string whole = read(name);
    for (const std::size_t size : {std::size_t{0}, whole.size() / 2, whole.size() - 1}) {
      write(name, whole.substr(0, size));
      expect_refused(4, run_ + "/" + name, "run the command that made it again", " --json");
    }
    write(name, whole);
  }
  EXPECT_EQ(run_graze("view " + run_ + " --json").code, 0);
}

TEST_F(ViewedFolder, IsRefusedWhereADigitWasChanged) {
  for (const char* name : {"record.json", "scene.toml", "result.json"}) {
    const std::string whole = read(name);
    std::string changed = whole;
    char& digit = changed[changed.find_last_of("012345678")];
    ++digit;
    write(name, changed);
    expect_refused(4, run_ + "/" + name, "run the command that made it again", " --json");
    write(name, whole);
  }
}

TEST_F(ViewedFolder, OfAnotherVersionIsRefused) {
  std::string text = read("record.json");
  const std::string key = "\"graze\":\"";
  const std::size_t at = text.find(key);
  ASSERT_NE(at, std::string::npos);
  text.insert(at + key.size(), "9.");
  write("record.json", text);
  expect_refused(4, run_ + "/record.json", "it was written by graze 9.");
}

TEST_F(ViewedFolder, OfAShareSaysWhatToDo) {
  run_ = (scratch_ / "share").string();
  ASSERT_EQ(run_graze(kViewedSweep + "--shard 1/2 --out " + run_ + " " + kOneMode).code, 0);
  expect_refused(4, run_ + "/record.json", "graze merge");
}

TEST_F(ViewedFolder, IsNotDrawnIntoWhatCannotBeWritten) {
  plot_ = (scratch_ / "none" / "p.svg").string();
  expect_refused(4, (scratch_ / "none").string(), "cannot write");
  plot_ = (scratch_ / "p.txt").string();
  expect_refused(2, plot_, "the name of a picture ends in");
  plot_ = (scratch_ / "p.svg").string();
  expect_refused(2, "--show", "nothing to choose", " --show speed");
  expect_refused(2, "--multipliers", "have no branches", " --multipliers");
  expect_refused(2, "--x-scale", "have no scales", " --x-scale log");
  expect_refused(2, "--x-range", "have no ranges", " --y-range 0:1");
  expect_refused(2, "--labels", "have no labels", " --labels none");
}

// Not the motion of the scene, but what the record tells of it is shown: nothing is computed.
TEST_F(ViewedFolder, IsReadAndNotComputed) {
  std::string text = read("record.json");
  const std::string between = ",\n\"values\": ";
  const std::size_t at = text.find(between);
  json head = json::parse(text.substr(0, at) + "}");
  std::string values = text.substr(at + between.size());
  values.resize(values.size() - 3);
  const json orbit = json::parse(read("result.json"))["orbits"][0];
  const std::string speed = orbit["speeds"][0].dump();
  for (std::size_t place = 0; (place = values.find(speed, place)) != std::string::npos;)
    values.replace(place, speed.size(), "0.4321");
  std::uint32_t rest = 0xffffffff;  // CRC-32, bit by bit
  for (const char letter : values) {
    rest ^= static_cast<unsigned char>(letter);
    for (int bit = 0; bit < 8; ++bit) rest = rest >> 1 ^ (rest & 1 ? 0xedb88320 : 0);
  }
  char checksum[9];
  std::snprintf(checksum, sizeof checksum, "%08x", ~rest);
  head["checksum"] = checksum;
  std::string first = head.dump();
  first.pop_back();
  write("record.json", first + between + values + "\n}\n");
  const Finished seen = run_graze("view " + run_);
  EXPECT_EQ(seen.code, 0) << seen.err;
  EXPECT_NE(seen.out.find("0.4321"), std::string::npos) << seen.out;
}

// What was not asked for when the result was made can be asked for later.
TEST(ViewLater, DrawsWithoutAPlotBefore) {
  const ScratchFolder scratch;
  const std::string plot = (scratch / "p.svg").string();
  for (const std::string& line : {"simulate --periods 200 " + scene("02_wagg_momentum.toml"),
                                  "compare --periods 200 --against beam.modes=2 " + kOneMode}) {
    const std::string run = (scratch / line.substr(0, 7)).string();
    ASSERT_EQ(run_graze(line + " --out " + run).code, 0);
    const Finished seen = run_graze("view " + run + " --plot " + plot);
    EXPECT_EQ(seen.code, 0) << seen.err;
    EXPECT_GT(read_text(plot).size(), 3000u);
    std::filesystem::remove(plot);
  }
}

TEST(ViewLater, ShowsTheMotionOfASpectrum) {
  const ScratchFolder scratch;
  const std::string run = (scratch / "run").string(), line = "simulate --periods 70 " + kOneMode;
  std::filesystem::create_directory(scratch / "once");
  const std::string once = (scratch / "once" / "p.svg").string();
  const std::string again = (scratch / "p.svg").string();
  ASSERT_EQ(run_graze(line + " --show spectrum --out " + run + " --plot " + once).code, 0);
  ASSERT_EQ(run_graze(line + " --plot " + once).code, 0);
  ASSERT_EQ(run_graze("view " + run + " --show motion --plot " + again).code, 0);
  for (const char* end : {"p.gp", "p.dat"})
    EXPECT_EQ(read_text(scratch / end), read_text(scratch / "once" / end)) << end;
  EXPECT_EQ(run_graze("view " + run + " --show returns --plot " + again).code, 2);
  EXPECT_EQ(run_graze("view " + run + " --show shapes --plot " + again).code, 2);
  ASSERT_EQ(run_graze(line + " --out " + run).code, 0);
  EXPECT_EQ(run_graze("view " + run + " --show spectrum --plot " + again).code, 2);
}

TEST(ViewLater, ShowsAnotherQuantity) {
  const ScratchFolder scratch;
  const std::string run = (scratch / "map").string(), branches = (scratch / "branches").string();
  std::filesystem::create_directory(scratch / "once");
  const std::string line = "map --periods 200" + kViewedPlane + kOneMode + " --out " + run;
  const std::string once = (scratch / "once" / "p.svg").string();
  const std::string again = (scratch / "p.svg").string();
  ASSERT_EQ(run_graze(line + " --show impacts --plot " + once).code, 0);
  ASSERT_EQ(run_graze(line).code, 0);
  ASSERT_EQ(run_graze("view " + run + " --show impacts --plot " + again).code, 0);
  for (const char* end : {"p.gp", "p.dat"})
    EXPECT_EQ(read_text(scratch / end), read_text(scratch / "once" / end)) << end;
  const Finished unknown = run_graze("view " + run + " --show colour --plot " + again);
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(unknown.err.find("give one of attractor, impacts"), std::string::npos) << unknown.err;
  EXPECT_EQ(run_graze("view " + run + " --show exponent --plot " + again).code, 2);
  EXPECT_EQ(run_graze("view " + run + " --at stop.1 --plot " + again).code, 2);

  const std::string trace =
      "continue --amplitudes --parameter forcing.frequency --from 58 --to 62 " + kOneMode;
  ASSERT_EQ(run_graze(trace + " --out " + branches + " --show max --plot " + once).code, 0);
  ASSERT_EQ(run_graze(trace + " --out " + branches).code, 0);
  ASSERT_EQ(run_graze("view " + branches + " --show max --plot " + again).code, 0);
  for (const char* end : {"p.gp", "p.dat"})
    EXPECT_EQ(read_text(scratch / end), read_text(scratch / "once" / end)) << end;
  EXPECT_EQ(run_graze("view " + branches + " --show max --at probe.7 --plot " + again).code, 2);
}

}  // namespace
}  // namespace graze
