// Pictures of runs, by what their scripts and their data say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "picture_script.hpp"

namespace graze {
namespace {

class RunPictures : public PictureScripts {};

TEST_F(RunPictures, ShapesStandAtTheTimesAskedForWithinTheRun) {
  const std::string command =
      "simulate " + scene("02_wagg_momentum.toml") + " --duration 0.5 --show shapes --shapes-at ";
  const std::string text = script(command + "0.4,0.1,0.4");
  EXPECT_LT(text.find("'t = 0.1 s'"), text.find("'t = 0.4 s'"));
  // At the tip, where the stop is 1.05 mm below, the beam is no lower.
  for (const char* series : {"series1", "series2"}) {
    ASSERT_EQ(data(series).size(), 201U);
    EXPECT_NEAR(data(series).front().second, 0.0, 1e-12);  // clamped
    EXPECT_GE(data(series).back().second, -1.05 - 1e-9);
  }
  EXPECT_NE(refusal(command + "0.6").find("beyond the end of the run"), std::string::npos);
}

// Without damping every contact on a spring of stiffness k at the rest position of an oscillator of
// mass 1 and frequency w is half a period of one of frequency sqrt(w^2 + k): from the speed w it
// rises to k w / sqrt(w^2 + k).
TEST_F(RunPictures, ForcesOfCompliantStopsAreDrawnThemselves) {
  const std::string command = "simulate " + scene("12_spring_dashpot_oscillator.toml") +
                              " --set forcing.amplitude=0 --set modal.damping_ratios=[0] --set "
                              "'stop.spring={stiffness=400.0, exponent=1.0}' --duration 40 "
                              "--record none --show forces";
  script(command);
  const double k = 400.0, peak = k / std::sqrt(1.0 + k), pi = std::numbers::pi;
  const std::vector<std::pair<double, double>> forces = data("series1");
  int peaks = 0;
  for (const auto& [time, force] : forces) {
    EXPECT_LE(force, peak * (1.0 + 1e-8)) << time;
    EXPECT_GE(force, 0.0) << time;
    if (force > peak * (1.0 - 1e-8)) ++peaks;
  }
  // Half a period of the free motion, then half of the contact's.
  const double span = forces.back().first - forces.front().first;
  EXPECT_EQ(peaks, static_cast<int>(span / (pi + pi / std::sqrt(1.0 + k))));
  script(command + " --forces 100");
  EXPECT_EQ(data("series1").size(), 200U);
}

// Windows that do not fit the period would let the means of what repeats beat.
TEST_F(RunPictures, MeansOfForcesRepeatWithTheForcing) {
  // Settled on one impact a period.
  script("simulate " + scene("05_wagg_one_mode.toml") +
         " --set forcing.frequency=40 --duration 31 --amplitudes-from 30 --record none --show "
         "forces");
  const std::vector<std::pair<double, double>> means = data("series1");
  const double length =
      2.0 * (means.back().first - means.front().first) / static_cast<double>(means.size());
  const double each = 2.0 * std::numbers::pi / 40.0 / length;
  EXPECT_NEAR(each, std::round(each), 1e-4);  // times are written with nine digits
  const auto stride = static_cast<std::size_t>(2 * std::lround(each));
  ASSERT_GT(means.size(), 4 * stride);
  for (std::size_t i = stride; i < means.size(); ++i)
    EXPECT_NEAR(means[i].second, means[i - stride].second, 1e-6) << means[i].first;
}

TEST_F(RunPictures, ForcesOfManyStopsAreRowsInOneScale) {
  // Five stops of one oscillator at different gaps: the nearest takes all impacts.
  std::string command =
      "simulate " + scene("04_impact_oscillator.toml") + " --periods 5 --show forces --forces 50";
  for (int i = 2; i <= 5; ++i)
    command += " --set 'stop." + std::to_string(i) +
               "={shape=[1.0], gap=" + std::to_string(10 * i) + ", restitution=0.5}'";
  script(command);
  // Two ends of 50 windows; the largest force is 0.9 of the distance between rows.
  ASSERT_EQ(data("series1").size(), 100U);
  double largest = 0.0;
  for (const auto& [time, level] : data("series1")) largest = std::max(largest, level);
  EXPECT_NEAR(largest, 1.9, 1e-9);
  for (const auto& [time, level] : data("series5")) EXPECT_EQ(level, 5.0);
  EXPECT_EQ(run_graze("simulate " + scene("04_impact_oscillator.toml") +
                      " --set stop=[] --show forces --plot x.png")
                .code,
            2);
}

// The samples of the table do not change with the picture, which takes more of them.
TEST_F(RunPictures, RecordedSamplesAreTheSameWithAPicture) {
  const auto samples = [&](const std::string& more) {
    const std::string folder = (scratch / "out").string();
    const Finished run = run_graze("simulate " + scene("05_wagg_one_mode.toml") +
                                   " --periods 20 --record samples --out " + folder + more);
    EXPECT_EQ(run.code, 0) << run.err;
    return read_text(scratch / "out" / "samples.csv");
  };
  const std::string plain = samples("");
  EXPECT_EQ(samples(" --energy --plot " + (scratch / "x.svg").string()).size() > plain.size(),
            true);
  const std::string drawn = samples(" --plot " + (scratch / "x.svg").string());
  std::istringstream a(plain), b(drawn);
  std::string line_a, line_b;
  std::size_t rows = 0;
  std::getline(a, line_a), std::getline(b, line_b);
  for (; std::getline(a, line_a); ++rows) {
    ASSERT_TRUE(std::getline(b, line_b));
    EXPECT_TRUE(line_b.starts_with(line_a)) << line_a << "\n" << line_b;
  }
  EXPECT_FALSE(std::getline(b, line_b));
  EXPECT_EQ(rows, 2000U);
  // Four hundred samples a forcing period, twelve of them.
  EXPECT_GT(data("displacement").size(), 4000U);
}

}  // namespace
}  // namespace graze
