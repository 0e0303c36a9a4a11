// A displacement has a direction: u counts away from the clamp's side as the scene says, towards a
// stop counts the other way where the stop is below. Every axis says which it shows.
#include <gtest/gtest.h>

#include <regex>

#include "apps/program.hpp"

namespace graze {
namespace {

// What is written at the axes of a gnuplot script; the lines of an upright name are joined.
std::vector<std::string> axis_names(const std::string& script) {
  const std::regex across("set x2?label '([^']*)'"),
      upright("set label '([^']*)' at screen [^,]*, graph 0.5 center rotate");
  std::vector<std::string> names;
  bool goes_on = false;
  std::istringstream stream(script);
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (std::regex_search(line, match, upright)) {
      if (goes_on)
        names.back() += " " + match[1].str();
      else
        names.push_back(match[1]);
      goes_on = true;
      continue;
    }
    goes_on = false;
    if (std::regex_search(line, match, across)) names.push_back(match[1]);
  }
  return names;
}

// How many of the axes have a direction; each of them says which.
int directed_axes(const std::string& arguments) {
  const ScratchFolder scratch;
  const Finished run = run_graze(arguments + " --quiet --plot " + (scratch / "x.svg").string());
  EXPECT_TRUE(run.code == 0 || run.code == 3) << run.err;
  int directed = 0;
  for (const std::string& name : axis_names(read_text(scratch / "x.gp"))) {
    if (!std::regex_search(name, std::regex("displacement|velocity|deflection|^towards"))) continue;
    ++directed;
    EXPECT_TRUE(std::regex_search(name, std::regex("(towards|→) |(displacement|velocity|along) u")))
        << arguments << ": " << name;
  }
  return directed;
}

const std::string kMeasured = std::string(GRAZE_SOURCE_DIR) + "/data/measurements/";

TEST(AxisDirections, AreToldByEveryPicture) {
  const std::string below = scene("02_wagg_momentum.toml");
  const std::string probes =
      " --set probe.1.position=0.3 --set probe.2.position=0.3 --set probe.2.quantity=velocity";
  // Displacement, velocity, two probes, and both axes of the portrait.
  EXPECT_EQ(directed_axes("simulate --periods 4 " + below + probes), 6);
  EXPECT_GE(directed_axes("simulate --duration 0.2 " + scene("10_two_supports.toml")), 4);
  EXPECT_GE(directed_axes("simulate --duration 0.01 " + scene("17_yigit_lee_wang_1.toml")), 4);
  EXPECT_EQ(directed_axes("orbit " + scene("05_wagg_one_mode.toml")), 3);
  EXPECT_EQ(directed_axes("orbit --set beam.modes=3 --set stop.restitution=0.2 --set "
                          "forcing.frequency=44 " +
                          below),
            3);
  EXPECT_EQ(directed_axes("simulate --periods 40 --section stroboscopic " + below), 2);
  EXPECT_GE(directed_axes("diagram --section stroboscopic --branches none --points 3 --periods 20 "
                          "--parameter forcing.frequency --from 30 --to 40 " +
                          below),
            1);
  EXPECT_EQ(directed_axes("compare --against beam.modes=3 --duration 1 " + below), 2);
  EXPECT_GE(directed_axes("fit " + kMeasured + "response.toml " + kMeasured +
                          "response.csv --max-evaluations 3 --parameter "
                          "damping.viscous=0.001:0.2"),
            1);
}

// A page names its panels, and says with the name which way they count.
TEST(AxisDirections, AreToldByThePageOfAMotion) {
  const ScratchFolder scratch;
  const Finished run = run_graze("simulate --periods 2 --plot " + (scratch / "x.html").string() +
                                 " " + scene("02_wagg_momentum.toml"));
  if (run.code == 4) GTEST_SKIP() << run.err;
  const std::string page = read_text(scratch / "x.html");
  for (const char* name : {"displacement", "velocity"})
    EXPECT_NE(page.find("\"name\":\"" + std::string(name) + "\\ntowards the stop\""),
              std::string::npos)
        << name;
}

// A beam that falls is drawn rising where a stop below it is what the axis counts towards; the
// probe at the same place falls.
TEST(AxisDirections, OfAStopBelowAndAProbeAreOpposite) {
  const ScratchFolder scratch;
  const Finished run =
      run_graze("simulate --periods 4 --quiet --set probe.1.position=0.3 --plot " +
                (scratch / "x.svg").string() + " " + scene("02_wagg_momentum.toml"));
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string columns = read_text(scratch / "x.gp.dat");
  const auto extremes = [&](const std::string& data) {
    std::istringstream stream(columns.substr(columns.find("# [" + data + "]")));
    std::string line;
    std::getline(stream, line);
    double low = 0.0, high = 0.0, time = 0.0, value = 0.0;
    while (std::getline(stream, line) && !line.starts_with('#'))
      if (std::istringstream(line) >> time >> value)
        low = std::min(low, value), high = std::max(high, value);
    return std::pair{low, high};
  };
  const auto [low, high] = extremes("displacement");
  const auto [probe_low, probe_high] = extremes("panel3_probe1");
  // The stop is 1.05 mm below: that far the motion goes towards it, and the probe to minus that.
  EXPECT_NEAR(high, 1.05, 1e-6);
  EXPECT_NEAR(probe_low, -1.05, 0.02);
  EXPECT_NEAR(probe_high, -low, 0.02);
}

}  // namespace
}  // namespace graze
