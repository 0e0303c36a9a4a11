// Beams on a hub as a user meets them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.hpp"

namespace graze {
namespace {

using nlohmann::json;

const std::string kFirst = scene("17_yigit_lee_wang_1.toml");
const std::string kYigitMomentum = scene("19_yigit_momentum.toml");
const std::string kSensitivity = scene("20_yigit_sensitivity.toml");

// No impact for the first 0.1 s: the torque turns hub and beam.
TEST(HubCommand, FinalHoldsAngleAndRate) {
  const Finished run = run_graze(
      "simulate --json --duration 0.1 --set beam.area=2.4e-4 --set beam.density=2710 "
      "--set hub.inertia=5e-3 --set hub.torque.amplitude=0.24 " +
      kFirst);
  ASSERT_EQ(run.code, 0) << run.err;
  const json final = json::parse(run.out)["final"];
  EXPECT_EQ(final["q"].size(), 3u);
  EXPECT_EQ(final["qdot"].size(), 3u);
  EXPECT_GT(final["rate"].get<double>(), 0.0);
  const double mass = 2710.0 * 2.4e-4,
               inertia = 5e-3 + mass * 0.57 * 0.57 * 0.57 / 3.0 - mass * 0.02 * 0.02 * 0.02 / 3.0;
  // theta = T t^2/(2 J), but for what the beam bends.
  EXPECT_NEAR(final["angle"].get<double>() / (0.5 * 0.24 * 0.01 / inertia), 1.0, 0.05);
}

TEST(HubCommand, SamplesHaveTheHubsColumns) {
  const ScratchFolder out;
  const Finished run =
      run_graze("simulate --duration 0.01 --record samples --sample-rate 1000 --out " +
                (out / "run").string() + " " + kFirst);
  ASSERT_EQ(run.code, 0) << run.err;
  std::ifstream table(out / "run" / "samples.csv");
  std::string header;
  std::getline(table, header);
  EXPECT_EQ(header,
            "time,angle,rate,q1,q2,q3,qdot1,qdot2,qdot3,gap1,force1,probe_1,probe_2,probe_3");
}

TEST(HubCommand, GoesOnWhereItEnded) {
  const ScratchFolder out;
  const std::string folder = (out / "run").string();
  const std::string friction = " --set \"hub.friction={coulomb=0.01}\" ";
  ASSERT_EQ(
      run_graze("simulate --duration 0.3485 --out " + folder + friction + kYigitMomentum).code, 0);
  const Finished rest =
      run_graze("simulate --json --duration 0.7 --resume " + folder + friction + kYigitMomentum);
  ASSERT_EQ(rest.code, 0) << rest.err;
  const Finished whole = run_graze("simulate --json --duration 0.7 " + friction + kYigitMomentum);
  EXPECT_EQ(json::parse(rest.out)["final"], json::parse(whole.out)["final"]);
}

TEST(HubCommand, AStartBeyondAStopNamesTheAngle) {
  const Finished turned = run_graze("simulate --set initial.angle=0.5 " + kYigitMomentum);
  EXPECT_EQ(turned.code, 2);
  EXPECT_NE(turned.err.find("initial.angle: the motion starts 0.102 m beyond stop 1"),
            std::string::npos)
      << turned.err;
}

TEST(HubCommand, WhatNeedsAPeriodSaysSo) {
  for (const std::string& line :
       {"orbit " + kFirst, "continue --parameter stop.gap --from 0.1 --to 0.2 " + kFirst}) {
    const Finished run = run_graze(line);
    EXPECT_EQ(run.code, 2) << line;
    EXPECT_NE(run.err.find("under a forcing that repeats itself; a structure on a hub has none"),
              std::string::npos)
        << run.err;
    EXPECT_EQ(run.out, "");
  }
}

// The inertia of a hub at which hub and uniform beam vibrate at `omega`, from the bending line
// y = y0 K1 + y0' K2/b + y0'' K3/b^2 + y0''' K4/b^3 (Krylov's functions): y0 = R y0' at the hub, no
// moment and no shear at the tip, and the hub takes the beam's moment and R times its shear.
double inertia_for(double omega, double length, double rigidity, double mass, double radius) {
  const double b = std::sqrt(std::sqrt(mass * omega * omega / rigidity)), z = b * length;
  const double k1 = 0.5 * (std::cosh(z) + std::cos(z)), k2 = 0.5 * (std::sinh(z) + std::sin(z)),
               k3 = 0.5 * (std::cosh(z) - std::cos(z)), k4 = 0.5 * (std::sinh(z) - std::sin(z));
  // y0' = 1; what y0''/b^2 and y0'''/b^3 must cancel at the tip.
  const double moment = -(radius * k3 + k4 / b), shear = -(radius * k2 + k3 / b),
               determinant = k1 * k1 - k2 * k4,
               curvature = b * b * (moment * k1 - k2 * shear) / determinant,
               change = b * b * b * (k1 * shear - k4 * moment) / determinant;
  return rigidity * (radius * change - curvature) / (omega * omega);
}

// vibration.csv is a cosine of 66.5 Hz with noise; the scene keeps three modes, which changes a
// frequency by less than 1e-4 of it (hub_beam_test), the inertia by some 1e-3 of it.
TEST(HubCommand, FitFindsTheInertiaBehindAFrequency) {
  const std::string measured = std::string(GRAZE_SOURCE_DIR) + "/data/measurements/vibration";
  const Finished run = run_graze("fit --json " + measured + ".toml " + measured +
                                 ".csv --parameter hub.inertia=1e-4:5e-3 "
                                 "--parameter initial.q.1=-1e-2:1e-2 "
                                 "--parameter initial.q.2=-1e-2:1e-2 "
                                 "--parameter initial.q.3=-1e-2:1e-2");
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out), found = document["parameters"][0];
  EXPECT_EQ(document["outcome"], "fitted");
  const double expected = inertia_for(2.0 * 3.14159265358979 * 66.5, 0.55, 6.895e10 * 5.41968e-10,
                                      2710.0 * 1.6129e-4, 0.02);
  EXPECT_LE(found["interval"][0].get<double>(), expected);
  EXPECT_GE(found["interval"][1].get<double>(), expected);
  EXPECT_NEAR(found["value"].get<double>() / expected, 1.0, 0.01);
}

TEST(HubCommand, SensitivitiesOverTheDamping) {
  const std::string line =
      "compare --json --sensitivity --duration 0.15 --parameter stop.spring.damping.coefficient "
      "--from 100 --to 1000 --points 4 --reference 500 --second hub.inertia --second-values "
      "4.992e-3,2e-2 " +
      kSensitivity;
  const Finished run = run_graze(line);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "compared");
  ASSERT_EQ(document["curves"].size(), 2u);
  for (const json& curve : document["curves"]) {
    // s1 adds up to nothing, and s2 is what it says.
    double sum = 0.0;
    for (const json& point : curve["points"]) {
      sum += point["s1"][0].get<double>();
      EXPECT_NEAR(
          point["s2"][1].get<double>(),
          1.0 - point["ends"][1].get<double>() / curve["reference"]["ends"][1].get<double>(),
          1e-12);
      EXPECT_GE(point["impacts"].size(), 1u);
    }
    EXPECT_NEAR(sum, 0.0, 1e-12);
  }
  EXPECT_EQ(run_graze(line + " --threads 1").out, run.out);
}

// What docs/yigit_1990.md tells of s1 and s2, from the command that it shows. Percentages with a
// digit after the point are bounds, the others rounded.
TEST(HubCommand, SensitivitiesAreThoseOnThePage) {
  const Finished run = run_graze(
      "compare --json --sensitivity --duration 0.2 --parameter stop.spring.damping.coefficient "
      "--from 0 --to 1000 --reference 500 --second hub.inertia --second-values 2.787e-4,2.7e-2 " +
      kSensitivity);
  ASSERT_EQ(run.code, 0) << run.err;
  const json curves = json::parse(run.out)["curves"];
  const auto largest = [&](int hub, const char* which, int probe, double from) {
    double value = 0.0;
    for (const json& point : curves[hub]["points"])
      if (point["value"].get<double>() >= from)
        value = std::max(value, std::abs(point[which][probe].get<double>()));
    return value;
  };
  const auto bound = [&](int hub, const char* which, int probe, double from) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1)
         << std::ceil(1e3 * largest(hub, which, probe, from)) / 10.0 << " %";
    return text.str();
  };
  const auto rounded = [&](int hub, const char* which, int probe) {
    return std::to_string(std::lround(100.0 * largest(hub, which, probe, 0.0)));
  };
  const std::string page = read_text(std::string(GRAZE_SOURCE_DIR) + "/docs/yigit_1990.md");
  for (const std::string& told :
       {bound(0, "s1", 0, 0.0) + " and " + bound(1, "s1", 0, 0.0) + " at C2 = 0; within " +
            bound(0, "s1", 0, 100.0) + " and " + bound(1, "s1", 0, 100.0) + " from 100 kg/s on",
        "light hub up to " + rounded(0, "s2", 1) + " %, within " + bound(0, "s2", 1, 100.0) +
            " from 100 kg/s on; heavy hub up to " + rounded(1, "s2", 1) + " %, within " +
            bound(1, "s2", 1, 350.0) + " from 350 kg/s on",
        "Its deflection: up to " + rounded(0, "s2", 0) + " and " + rounded(1, "s2", 0) +
            " %, within " + bound(0, "s2", 0, 100.0) + " from 100 and " + bound(1, "s2", 0, 350.0) +
            " from 350 kg/s on"})
    EXPECT_NE(page.find(told), std::string::npos) << told;
}

TEST(HubCommand, SensitivitiesNeedProbesAndARange) {
  const Finished none = run_graze(
      "compare --sensitivity --duration 0.1 --parameter stop.gap --from "
      "1 --to 2 " +
      scene("06_bouncing_ball.toml"));
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("there is no [[probe]]"), std::string::npos) << none.err;
  EXPECT_EQ(run_graze("compare --sensitivity --duration 0.1 " + kSensitivity).code, 2);
  EXPECT_EQ(
      run_graze("compare --sensitivity --parameter stop.gap --from 1 --to 2 " + kSensitivity).code,
      2);
}

}  // namespace
}  // namespace graze
