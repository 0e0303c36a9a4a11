// Loci of doublings that meet a grazing, of the oscillator u'' + 2 zeta u' + u = A cos(w t), u <=
// 1, in closed form: as an impact vanishes multipliers grow as G/v, G the way by which an impulse
// there has moved the oscillator when the orbit of period p comes back. That is none where m half
// oscillations fit,
//
//   w = 2 p sqrt(1 - zeta^2)/m,   A = sqrt((1 - w^2)^2 + (2 zeta w)^2),
//
// the amplitude at which the linear response just reaches the stop.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "program.hpp"

namespace graze {
namespace {

using nlohmann::json;

// Of (2, 1) orbits over frequency and amplitude.
json doublings(double zeta, double restitution, double amplitude, double frequency,
               const std::string& steps) {
  const Finished run = run_graze(fmt::format(
      "continue {} --set 'modal.damping_ratios=[{}]' --set stop.gap=1.0 --set 'initial.q=[0.0]' "
      "--set stop.restitution={} --set forcing.amplitude={} --set forcing.frequency={} "
      "--parameter forcing.frequency --from 0.78 --to 1 --second forcing.amplitude "
      "--second-from 0.03 --second-to 0.45 --period 2 --impacts 1 --locus PD --json {}",
      scene("04_impact_oscillator.toml"), zeta, restitution, amplitude, frequency, steps));
  EXPECT_EQ(run.code, 0) << run.err;
  return json::parse(run.out);
}

void expect_meetings(double zeta, double restitution, double amplitude, double frequency,
                     const std::string& steps = "") {
  SCOPED_TRACE(fmt::format("zeta {} r {} from A {} w {} {}", zeta, restitution, amplitude,
                           frequency, steps));
  const json found = doublings(zeta, restitution, amplitude, frequency, steps);
  for (const double halves : {4.0, 5.0}) {
    const double w = 4.0 * std::sqrt(1.0 - zeta * zeta) / halves;
    const double a = std::hypot(1.0 - w * w, 2.0 * zeta * w);
    int meetings = 0;
    for (const json& locus : found["loci"]) {
      EXPECT_NE(locus["ends"][0], "not converged");
      EXPECT_NE(locus["ends"][1], "not converged");
      for (const json& special : locus["special"])
        if (std::abs(special["value"].get<double>() - w) < 1e-9 &&
            std::abs(special["second"].get<double>() - a) < 1e-9)
          meetings += special["label"] == "PDGR" ? 1 : 0;
    }
    EXPECT_EQ(meetings, 1) << halves;
  }
}

// Whatever the step, and wherever in the plane the scene itself stands.
TEST(MeetingGrazing, DoublingsEndWhereTheClosedFormHasIt) {
  for (const char* steps : {"", "--max-step 0.002", "--max-step 0.001"})
    expect_meetings(0.02, 0.9, 0.3475333988945534, 0.81, steps);
  expect_meetings(0.02, 0.9, 0.2, 0.9, "--max-step 0.001");
  expect_meetings(0.02, 0.9, 0.4, 0.9);
  expect_meetings(0.02, 0.8, 0.3, 0.85);
  expect_meetings(0.03, 0.9, 0.3, 0.85);
}

const char* const kTwoModes = R"([modal]
frequencies = [1.0, 5.038982107768481]
damping_ratios = [0.5, 0.18715916382755424]
participation = [1.0, 0.2995833008697377]
[forcing]
kind = "modal"
amplitude = 1.0
frequency = 0.638860173981165
phase = -2.6488888828114447
[[stop]]
shape = [1.0, -0.19389917574482163]
gap = 1.1130563755319858
restitution = 0.5230813333303654
)";

// As an impact vanishes a multiplier goes as -C/v: there is a doubling beside every such grazing,
// within the branch's last step or not.
TEST(MeetingGrazing, BranchesPassTheDoublingBesideIt) {
  const ScratchFolder scratch;
  const std::string file = (scratch / "two_modes.toml").string();
  std::ofstream(file) << kTwoModes;
  for (const char* range : {"0.5 --to 0.6", "0.3 --to 0.7", "0.05 --to 0.95", "0.7 --to 0.3",
                            "0.52 --to 0.53", "0.4 --to 0.66"}) {
    const Finished run =
        run_graze("continue " + file +
                  " --parameter modal.damping_ratios.1 --impacts 1 --json --from " + range);
    ASSERT_EQ(run.code, 0) << run.err;
    int doublings = 0, grazings = 0;
    const json found = json::parse(run.out);
    for (const json& branch : found["branches"])
      for (const json& special : branch["special"]) {
        const double value = special["value"];
        if (special["label"] == "PD" && std::abs(value - 0.5276159465) < 1e-9) ++doublings;
        if (special["label"] == "GR" && std::abs(value - 0.5276558320) < 1e-9) ++grazings;
      }
    EXPECT_EQ(doublings, 1) << range;
    EXPECT_EQ(grazings, 1) << range;
  }
}

}  // namespace
}  // namespace graze
