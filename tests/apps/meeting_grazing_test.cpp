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

}  // namespace
}  // namespace graze
