// The response without impacts as a branch, and amplitudes along branches, against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <tuple>
#include <vector>

#include "branch_checks.hpp"
#include "graze/bifurcation/trace/branch_amplitudes.hpp"
#include "graze/orbit/closed_form/response.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// m = k = 1, c = 0.05, F = 0.02 cos(W t) + load; |u| is their transfer function's.
Scene oscillator(const std::string& more) {
  return parse_scene(
      "[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.025]\nparticipation = [1.0]\n"
      "inertia = [1.0]\n[forcing]\namplitude = 0.02\nfrequency = 0.7\nphase = 0.4\n" +
          more,
      "oscillator");
}

double size_at(double frequency) {
  return 0.02 / std::hypot((1.0 - frequency) * (1.0 + frequency), 0.05 * frequency);
}

// Where that is `size`, below and above resonance: W^4 - (2 - c^2) W^2 + 1 - (F/size)^2 = 0.
double frequency_of(double size, double side) {
  const double half = 1.0 - 0.5 * 0.05 * 0.05;
  return std::sqrt(half + side * std::sqrt(half * half - 1.0 + std::pow(0.02 / size, 2)));
}

OrbitBranches response(const SystemFamily& family, double from, double to,
                       bool keep_virtual = false) {
  BranchOptions options;
  options.from = from;
  options.to = to;
  options.impacts = 0;
  options.response = true;
  options.keep_virtual = keep_virtual;
  return trace_orbits(family, options);
}

const std::string kStop = "[[stop]]\nshape = [1.0]\nrestitution = 0.5\ngap = ";

TEST(ResponseBranches, EndAtTheGrazingsOfTheTransferFunction) {
  const SystemFamily family(oscillator(kStop + "0.1\n"), "forcing.frequency");
  const OrbitBranches result = response(family, 0.5, 1.7);
  ASSERT_EQ(result.branches.size(), 2u);
  for (const int side : {0, 1}) {
    const OrbitBranch& branch = result.branches[static_cast<std::size_t>(side)];
    EXPECT_EQ(branch.pattern.impacts(), 0);
    ASSERT_EQ(branch.special.size(), 1u);
    EXPECT_EQ(branch.special[0].kind, SpecialKind::kGrazing);
    EXPECT_NEAR(branch.special[0].at.value, frequency_of(0.1, side == 0 ? -1.0 : 1.0), 1e-14);
    EXPECT_TRUE(branch.special[0].solution.bracket->converged);
    for (const OrbitBranchPoint& point : branch.points) {
      EXPECT_TRUE(point.orbit.admissible);
      EXPECT_TRUE(point.orbit.stable.value_or(false));
      EXPECT_NEAR(*point.orbit.clearance, 0.1 - size_at(point.value), 1e-14);
      EXPECT_NEAR(std::abs(point.orbit.multipliers[0].value),
                  std::exp(-0.025 * kTurn / point.value), 1e-14);
    }
  }
  EXPECT_EQ(result.branches[0].ends[1], OrbitBranchEnd::kGrazing);
  EXPECT_EQ(result.branches[1].ends[0], OrbitBranchEnd::kGrazing);
}

TEST(ResponseBranches, HaveTheAmplitudesOfTheTransferFunction) {
  const SystemFamily family(oscillator(kStop + "0.1\n"), "forcing.frequency");
  const OrbitBranches result = response(family, 0.5, 1.7);
  const BranchAmplitudes measured = measure_branches(family, result, 0);
  ASSERT_EQ(measured.places.size(), 1u);
  for (std::size_t i = 0; i < result.branches.size(); ++i)
    for (std::size_t k = 0; k < result.branches[i].points.size(); ++k) {
      const double size = size_at(result.branches[i].points[k].value);
      const Amplitude& u = measured.branches[i].points[k].rows[0];
      EXPECT_NEAR(u.largest(), size, 1e-12 * size);
      EXPECT_NEAR(u.rms, size / std::sqrt(2.0), 1e-12 * size);
      EXPECT_NEAR(*u.speed, size * result.branches[i].points[k].value, 1e-12 * size);
      EXPECT_EQ(measured.branches[i].points[k].stops[0].impacts, 0);
      EXPECT_EQ(measured.branches[i].points[k].stops[0].impulse, 0.0);
    }
}

// The largest response is 0.4001: a gap that is a part of 1e-4 less is passed within a fortieth of
// a step, and one that is more is not touched.
TEST(ResponseBranches, SeePeaksBetweenTheirPoints) {
  const double top = size_at(std::sqrt(1.0 - 0.5 * 0.05 * 0.05));
  const double gap = top * (1.0 - 1e-6);
  const SystemFamily family(oscillator(kStop + std::to_string(0.0) + "\n"), "forcing.frequency");
  Scene scene = family.scene();
  *find_parameter(scene, "stop.gap") = gap;
  const OrbitBranches touched = response(SystemFamily(scene, "forcing.frequency"), 0.5, 1.7);
  ASSERT_EQ(touched.branches.size(), 2u);
  // Where the curve is flat its crossing is known to the square root of rounding.
  EXPECT_NEAR(touched.branches[0].special[0].at.value, frequency_of(gap, -1.0), 1e-10);
  EXPECT_NEAR(touched.branches[1].special[0].at.value, frequency_of(gap, 1.0), 1e-10);
  *find_parameter(scene, "stop.gap") = top * (1.0 + 1e-6);
  const OrbitBranches clear = response(SystemFamily(scene, "forcing.frequency"), 0.5, 1.7);
  ASSERT_EQ(clear.branches.size(), 1u);
  EXPECT_TRUE(clear.branches[0].special.empty());
}

// With virtual solutions it is the curve of the linear structure, in one piece.
TEST(ResponseBranches, GoOnThroughTheStopsWhereThatIsAsked) {
  const SystemFamily family(oscillator(kStop + "0.1\n"), "forcing.frequency");
  const OrbitBranches result = response(family, 0.5, 1.7, true);
  ASSERT_EQ(result.branches.size(), 1u);
  EXPECT_EQ(result.branches[0].special.size(), 2u);
  const BranchAmplitudes measured = measure_branches(family, result, 1);
  double largest = 0.0;
  for (std::size_t k = 0; k < result.branches[0].points.size(); ++k) {
    const OrbitBranchPoint& point = result.branches[0].points[k];
    const double size = measured.branches[0].points[k].rows[0].largest();
    EXPECT_NEAR(size, size_at(point.value), 1e-12 * size);
    EXPECT_EQ(point.orbit.admissible, size_at(point.value) <= 0.1 ||
                                          point.value == result.branches[0].special[0].at.value ||
                                          point.value == result.branches[0].special[1].at.value);
    largest = std::max(largest, size);
  }
  EXPECT_GT(largest, 0.38);
}

// Two stops, the load moves the structure towards the upper one: that is met on the way to
// resonance, the lower one is not at all outside.
TEST(ResponseBranches, EndAtWhicheverStopIsMetFirst) {
  const SystemFamily family(oscillator(kStop + "0.1\n" + kStop +
                                       "0.1\nside = \"below\"\n[gravity]\nacceleration = 0.03\n"),
                            "forcing.amplitude");
  const OrbitBranches result = response(family, 0.001, 0.2);
  ASSERT_EQ(result.branches.size(), 1u);
  ASSERT_EQ(result.branches[0].special.size(), 1u);
  EXPECT_NEAR(result.branches[0].special[0].at.value, 0.02 * 0.07 / size_at(0.7), 1e-15);
}

// Two stops that are touched at once, which rounding tells apart: still one grazing each way.
TEST(ResponseBranches, EndOnceWhereSeveralStopsAreTouched) {
  for (const double part : {3.0, 0.7, 0.1, 7.0}) {
    const std::string other =
        "[[stop]]\nshape = [" + std::to_string(part) +
        "]\nrestitution = 0.5\nside = \"below\"\ngap = " + std::to_string(0.1 * part) + "\n";
    const Scene scene = oscillator(kStop + "0.1\n" + other);
    const OrbitBranches result = response(SystemFamily(scene, "forcing.frequency"), 0.5, 1.7);
    ASSERT_EQ(result.branches.size(), 2u) << part;
    for (const int side : {0, 1}) {
      const OrbitBranch& branch = result.branches[static_cast<std::size_t>(side)];
      ASSERT_EQ(branch.special.size(), 1u) << part;
      EXPECT_NEAR(branch.special[0].at.value, frequency_of(0.1, side == 0 ? -1.0 : 1.0), 1e-14);
    }
    EXPECT_EQ(result.cut_short, 0);
    const OrbitBranches grown = response(SystemFamily(scene, "forcing.amplitude"), 0.001, 0.3);
    ASSERT_EQ(grown.branches.size(), 1u) << part;
    EXPECT_EQ(grown.branches[0].ends[1], OrbitBranchEnd::kGrazing);
  }
}

// Undamped resonances at 1, 2 and 3 rad/s part it; every part is found.
TEST(ResponseBranches, AreFoundBetweenUndampedResonances) {
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [1.0, 2.0, 3.0]\nparticipation = [1.0, 1.0, 1.0]\n"
      "[forcing]\namplitude = 0.01\nfrequency = 0.7\n"
      "[[stop]]\nshape = [1.0, 0.5, 0.5]\nrestitution = 0.5\ngap = 0.1\n",
      "three modes");
  const OrbitBranches result = response(SystemFamily(scene, "forcing.frequency"), 0.2, 4.0);
  ASSERT_EQ(result.branches.size(), 4u);
  for (const OrbitBranch& branch : result.branches)
    for (const SpecialPoint& special : branch.special) {
      const double w = special.at.value;
      EXPECT_NEAR(std::abs(0.01 / (1.0 - w * w) + 0.005 / (4.0 - w * w) + 0.005 / (9.0 - w * w)),
                  0.1, 1e-12);
    }
}

// Slopes by every parameter against differences.
TEST(Response, MovesWithEveryParameter) {
  const Scene scene = oscillator(kStop + "0.1\n[gravity]\nacceleration = 0.03\n");
  for (const char* name : {"forcing.frequency", "forcing.amplitude", "forcing.phase",
                           "modal.frequencies.1", "modal.damping_ratios.1", "modal.participation.1",
                           "modal.inertia.1", "gravity.acceleration"}) {
    const SystemFamily family(scene, name);
    const double value = family.value(), step = 1e-5;
    const System system = *family.at(value);
    const Response rate = response_rate(system, *family.tangent_at(value), *response_of(system));
    const Response up = *response_of(*family.at(value + step)),
                   down = *response_of(*family.at(value - step));
    EXPECT_NEAR(std::abs((up.amplitude - down.amplitude)[0] / (2.0 * step) - rate.amplitude[0]),
                0.0, 1e-8)
        << name;
    EXPECT_NEAR((up.offset - down.offset)[0] / (2.0 * step), rate.offset[0], 1e-8) << name;
  }
}

TEST(Response, IsNoneOfAFreeMassOrAtAnUndampedResonance) {
  System system = support::forced_oscillator(1.0, 0.0, 1.0, 0.5, 1.0, 0.1);
  EXPECT_FALSE(response_of(system).has_value());
  system.omega[0] = 0.0;
  EXPECT_FALSE(response_of(system).has_value());
  system.omega[0] = 2.0;
  EXPECT_NEAR(response_of(system)->amplitude[0].real(), 0.1 / 3.0, 1e-16);
}

// Under cos(W t) and a cos(2 W t + phase) the response is A1 cos t + A2 cos(2 t + turn), t from the
// peak of its first part. With turn 0 both peaks are one, A1 + A2; with half a turn there are two
// equal ones once 4 A2 > A1, A1^2/(8 A2) + A2, and the lowest value is A1 + A2 below.
TEST(ResponseBranches, GrazeWhereTheSumOfTwoHarmonicsDoes) {
  using std::numbers::pi;
  const double w = 0.7, gap = 0.1;
  const auto impedance = [](double of) { return Complex((1.0 - of) * (1.0 + of), 0.05 * of); };
  const Complex first = impedance(w), second = impedance(2.0 * w);
  const double size = 0.02 / std::abs(first);
  const double two_peaks = 0.5 * (gap + std::sqrt(gap * gap - 0.5 * size * size));
  for (const auto& [turn, side, grazing] :
       {std::tuple(0.0, "above", gap - size), std::tuple(pi, "above", two_peaks),
        std::tuple(pi, "below", gap - size)}) {
    const double phase = turn + std::arg(second) + 2.0 * (0.4 - std::arg(first));
    const Scene scene = parse_scene(
        fmt::format("[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.025]\n"
                    "[[forcing]]\nkind = \"point\"\nshape = [1.0]\namplitude = 0.02\n"
                    "frequency = {}\nphase = 0.4\n[[forcing]]\nkind = \"point\"\nshape = [1.0]\n"
                    "amplitude = 0.01\norder = 2\nphase = {:.17g}\n{}{}\nside = \"{}\"\n",
                    w, phase, kStop, gap, side),
        "two harmonics");
    const SystemFamily family(scene, "forcing.2.amplitude");
    const OrbitBranches result = response(family, 0.0, 0.15);
    ASSERT_EQ(result.branches.size(), 1u) << turn << side;
    const OrbitBranch& branch = result.branches[0];
    ASSERT_EQ(branch.special.size(), 1u) << turn << side;
    EXPECT_EQ(branch.special[0].kind, SpecialKind::kGrazing);
    EXPECT_NEAR(branch.special[0].at.value, grazing * std::abs(second), 1e-14) << turn << side;
    EXPECT_EQ(branch.ends[1], OrbitBranchEnd::kGrazing);
    for (const OrbitBranchPoint& point : branch.points) {
      EXPECT_TRUE(point.orbit.admissible);
      EXPECT_NEAR(std::abs(point.orbit.multipliers[0].value), std::exp(-0.025 * kTurn / w), 1e-14);
    }
  }
}

}  // namespace
}  // namespace graze
