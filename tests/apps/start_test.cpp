// continue --from-orbit and --from-state: branches through one orbit, without any search.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <fstream>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace graze {
namespace {

using nlohmann::json;

json told(const std::string& command) {
  const Finished run = run_graze(command + " --json");
  EXPECT_EQ(run.code, 0) << command << "\n" << run.out << run.err;
  return json::parse(run.out);
}

// The value of the one UZ.
double level_in(const json& document) {
  std::vector<double> found;
  for (const json& branch : document["branches"])
    for (const json& special : branch["special"])
      if (special["label"] == "UZ") found.push_back(special["value"].get<double>());
  EXPECT_EQ(found.size(), 1u);
  return found.empty() ? 0.0 : found[0];
}

std::string number(double value) { return json(value).dump(); }

bool is_near(const json& a, const json& b) {
  return std::abs(a.get<double>() - b.get<double>()) < 1e-9;
}

class Start : public ::testing::Test {
 protected:
  std::string folder(const std::string& name) const { return (scratch_ / name).string(); }

 private:
  ScratchFolder scratch_;
};

// An unstable orbit, whose speed is again its own where the gap is.
TEST_F(Start, FromAnOrbitThatWasFound) {
  const std::string oscillator = scene("04_impact_oscillator.toml");
  const json orbits = told("orbit " + oscillator + " --out " + folder("orbits"));
  EXPECT_FALSE(orbits["orbits"][0]["stable"].get<bool>());
  const json branches =
      told("continue " + oscillator + " --parameter stop.gap --from -0.1 --to 0.1 " +
           "--from-orbit " + folder("orbits") +
           " --level speed=" + number(orbits["orbits"][0]["speeds"][0].get<double>()));
  EXPECT_EQ(branches["branches"].size(), 1u);
  EXPECT_NEAR(level_in(branches), 0.0, 1e-12);
}

// The orbits of a page, each with the command that continues from exactly it.
TEST_F(Start, FromThePointsOfAPage) {
  const std::string file = folder("x.html");
  const Finished made = run_graze(
      "continue --quiet --parameter forcing.frequency --from 58 --to 62 "
      "--out " +
      folder("run") + " --plot " + file + " " + kOneMode);
  if (made.err.find("built without npm") != std::string::npos) GTEST_SKIP() << made.err;
  ASSERT_EQ(made.code, 0) << made.err;
  const std::string page = read_text(file), open = "id=\"orbits\">";
  const std::size_t from = page.find(open) + open.size();
  const json orbits = json::parse(page.substr(from, page.find("</script>", from) - from));
  std::size_t of_rows = 0, of_labels = 0;
  for (const json& orbit : orbits) {
    const std::string command = orbit["command"].get<std::string>();
    ASSERT_TRUE(command.starts_with("graze continue ")) << command;
    const bool is_row = command.find(" --from-orbit ") != std::string::npos;
    if (is_row ? of_rows++ % 8 > 0 : of_labels++ > 1) continue;
    bool there = false;
    const json result = told(command.substr(6) + " --quiet");
    for (const json& branch : result["branches"])
      for (const json& point : branch["points"])
        there = there || (is_near(point["value"], orbit["value"]) &&
                          is_near(point["speed"], orbit["impacts"][0]["speed"]));
    EXPECT_TRUE(there) << command;
  }
  EXPECT_GT(of_rows, 20u);
  EXPECT_GT(of_labels, 0u);
}

// Points of a branch that sticks, and of one on an elastic stop, in another parameter.
TEST_F(Start, FromAnyPointOfABranch) {
  const std::string sticking = folder("sticking.toml");
  std::ofstream(sticking) << "[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.1]\n"
                             "participation = [1.0]\n[forcing]\namplitude = 1.0\nfrequency = 0.8\n"
                             "[[stop]]\nshape = [1.0]\ngap = -0.3\nrestitution = 0.3\n";
  const struct {
    std::string scene, number, key;
  } cases[] = {{sticking, "stuck-duration", ""},
               {scene("../validation/nlvib_oscillator.toml"), "speed", "speed"}};
  for (const auto& one : cases) {
    SCOPED_TRACE(one.scene);
    const std::string first = folder(one.number);
    const json branch = told("continue " + one.scene +
                             " --parameter forcing.frequency --from 0.6 --to 1.4 --out " + first);
    const json& point = branch["branches"][0]["points"][20];
    const double value = one.key.empty() ? point["stuck_phases"][0]["duration"].get<double>()
                                         : point[one.key].get<double>();
    const json again =
        told("continue " + one.scene + " --parameter forcing.amplitude --from " +
             (one.key.empty() ? "0.9 --to 1.1" : "0.018 --to 0.022") + " --from-orbit " + first +
             " --orbit 21 --level " + one.number + "=" + number(value));
    EXPECT_EQ(again["branches"].size(), 1u);
    EXPECT_NEAR(level_in(again), one.key.empty() ? 1.0 : 0.02, 1e-10);
  }
}

// The same unstable orbit by its state at t = 0 to six digits, as another program might give it:
// from its impact in closed form.
TEST_F(Start, FromAStateOnAnUnstableOrbit) {
  const std::string oscillator = scene("04_impact_oscillator.toml");
  const json orbit = told("orbit " + oscillator)["orbits"][0];
  const double speed = orbit["speeds"][0].get<double>(), phase = orbit["phases"][0].get<double>();
  const double frequency = 2.8, decay = 0.05, damped = std::sqrt(1.0 - decay * decay);
  const std::complex<double> i(0.0, 1.0);
  const std::complex<double> response =
      1.0 / (1.0 - frequency * frequency + 2.0 * i * decay * frequency);
  const auto forced = [&](double at) { return response * std::exp(i * at); };
  const double y = -forced(phase).real();
  const double w = -0.8 * speed - (i * frequency * forced(phase)).real();
  const double t = (2.0 * std::acos(-1.0) - phase) / frequency, e = std::exp(-decay * t);
  const double c = std::cos(damped * t), s = std::sin(damped * t) / damped;
  const double x = e * (y * c + (w + decay * y) * s) + response.real();
  const double v = e * (w * c - (decay * w + y) * s) + (i * frequency * response).real();
  std::ofstream(folder("state.csv")) << "t,x,v\n0," << x << "," << v << "\n2.3,0,0\n";
  const json branches =
      told("continue " + oscillator + " --parameter stop.gap --from -0.1 --to 0.1 " +
           "--from-state " + folder("state.csv") + " --level speed=" + number(speed));
  EXPECT_EQ(branches["branches"].size(), 1u);
  EXPECT_NEAR(level_in(branches), 0.0, 1e-10);
}

// The end of a run lies anywhere in a forcing period.
TEST_F(Start, FromTheEndOfARun) {
  const std::string settled = scene("04_impact_oscillator.toml") + " --set forcing.frequency=2.2";
  ASSERT_EQ(run_graze("simulate " + settled + " --duration 500 --out " + folder("run")).code, 0);
  const json from_run = told("continue " + settled + " --parameter forcing.frequency --from 2 " +
                             "--to 2.5 --from-state " + folder("run"));
  const json searched =
      told("continue " + settled + " --parameter forcing.frequency --from 2 --to 2.5");
  ASSERT_EQ(from_run["branches"].size(), 1u);
  const json &a = from_run["branches"][0]["points"].back(),
             &b = searched["branches"][0]["points"].back();
  EXPECT_EQ(a["value"], b["value"]);
  EXPECT_NEAR(a["speed"].get<double>(), b["speed"].get<double>(), 1e-11);
}

TEST_F(Start, SaysWhatIsWrong) {
  const std::string oscillator = scene("04_impact_oscillator.toml");
  told("orbit " + oscillator + " --out " + folder("orbits"));
  std::ofstream(folder("late.csv")) << "t,x,v\n0.1,0,0\n";
  std::ofstream(folder("wide.csv")) << "t,x,y,v\n0,0,0,0\n";
  const struct {
    std::string what, sentence;
  } cases[] = {{"--from-orbit " + folder("orbits") + " --orbit 7", "there is no orbit 7"},
               {"--from-orbit " + folder("orbits") + " --set stop.gap=1", "is of another scene"},
               {"--from-orbit " + folder("orbits") + " --impacts 1", "--from-orbit"},
               {"--orbit 1", "--from-orbit"},
               {"--from-state " + folder("orbits"), "holds no run of graze simulate"},
               {"--from-state " + folder("late.csv"), "the first row must be at t = 0"},
               {"--from-state " + folder("wide.csv"), "it must have 3: time"},
               {"--from-state " + folder("none.csv"), "none.csv"}};
  for (const auto& wrong : cases) {
    SCOPED_TRACE(wrong.what);
    const Finished run = run_graze("continue " + oscillator +
                                   " --parameter stop.gap --from -0.1 --to 0.1 " + wrong.what);
    EXPECT_NE(run.code, 0);
    EXPECT_NE(run.err.find(wrong.sentence), std::string::npos) << run.err;
  }
}

}  // namespace
}  // namespace graze
