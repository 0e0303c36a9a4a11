// The assembled system: its numbers by hand, its start, its warnings.
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/assembly/system_warnings.hpp"
#include "graze/system/system.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "graze/system/detail/gap_value.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

constexpr double kB1 = 1.8751040687119611664;

Scene oscillator(const std::string& stop, const std::string& initial = "") {
  return parse_scene(
      "[modal]\nfrequencies = [2.0, 5.0]\nparticipation = [1.0, -0.5]\n"
      "inertia = [0.25, 0.75]\ndamping_ratios = [0.01, 0.02]\n"
      "[forcing]\nkind = \"modal\"\namplitude = 3.0\nfrequency = 4.0\nphase = 0.5\n" +
          stop + initial,
      "oscillator.toml");
}

const char* const kStop = "[[stop]]\nshape = [1.0, -2.0]\ngap = 0.1\nrestitution = 0.7\n";

TEST(System, OfGivenModesHoldsTheirNumbers) {
  const System system = assemble(oscillator(kStop));
  EXPECT_EQ(system.modes(), 2);
  EXPECT_EQ(system.omega[0], 2.0);
  EXPECT_EQ(system.omega[1], 5.0);
  EXPECT_DOUBLE_EQ(system.delta()[0], 0.02);
  EXPECT_DOUBLE_EQ(system.delta()[1], 0.1);
  ASSERT_TRUE(system.forcing());
  EXPECT_EQ(system.forcing()->frequency, 4.0);
  EXPECT_EQ(system.forcing()->phase, 0.5);
  EXPECT_DOUBLE_EQ(system.forcing()->amplitude[0], 3.0);
  EXPECT_DOUBLE_EQ(system.forcing()->amplitude[1], -1.5);
  EXPECT_DOUBLE_EQ(system.period(), std::numbers::pi / 2.0);
  ASSERT_EQ(system.stops.size(), 1u);
  EXPECT_EQ(system.stops[0].row[1], -2.0);
  EXPECT_EQ(system.stops[0].gap, 0.1);
  EXPECT_EQ(system.stops[0].restitution().at_rest(), 0.7);
  EXPECT_DOUBLE_EQ(system.stops[0].direction()[1], -2.0 / 5.0);
}

TEST(System, MovingBaseForcesWithTheSquareOfItsFrequency) {
  // Of the unit beam: P Omega^2 times the integral of the shape, 2 s/b.
  const Scene scene = parse_scene(
      "[beam]\nlength = 1.0\nyoungs_modulus = 1.0\nsecond_moment = 1.0\ndensity = 1.0\n"
      "area = 1.0\nmodes = 1\n[forcing]\nkind = \"base\"\namplitude = 0.01\nfrequency = 3.0\n"
      "[[stop]]\nposition = 1.0\ngap = 0.1\nrestitution = 0.5\nside = \"below\"\n",
      "unit.toml");
  const System system = assemble(scene);
  const double s = (std::cosh(kB1) + std::cos(kB1)) / (std::sinh(kB1) + std::sin(kB1));
  EXPECT_NEAR(system.forcing()->amplitude[0], 0.01 * 9.0 * 2.0 * s / kB1, 1e-16);
  EXPECT_NEAR(system.omega[0], kB1 * kB1, 1e-15);
  // The stop below looks the other way: the row points into it.
  EXPECT_NEAR(system.stops[0].row[0], -2.0, 1e-15);
  EXPECT_NEAR(system.stops[0].direction()[0], -0.5, 1e-15);
}

TEST(System, SidesDifferBySignsOnly) {
  const System above = assemble(support::shipped_scene("01_wagg_2004", {"stop.side=\"above\""}));
  const System below = assemble(support::shipped_scene("01_wagg_2004"));
  EXPECT_EQ(above.stops[0].row, -below.stops[0].row);
  EXPECT_LE((above.stops[0].direction() + below.stops[0].direction()).norm(), 1e-16);
  EXPECT_EQ(above.forcing()->amplitude, below.forcing()->amplitude);
}

TEST(System, WhatIsNotNamedIsAbsent) {
  const Scene scene = parse_scene("[modal]\nfrequencies = [2.0]\n", "bare.toml");
  const System system = assemble(scene);
  EXPECT_FALSE(system.forcing());
  EXPECT_TRUE(system.stops.empty());
  EXPECT_EQ(system.delta()[0], 0.0);
  EXPECT_TRUE(system_warnings(scene, system).empty());
  EXPECT_EQ(collocation_condition(modal_model(scene)), 0.0);
}

std::string start_error(const Scene& scene) {
  try {
    initial_state(scene, assemble(scene));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(System, StartsAtRestUnlessTold) {
  const Scene scene = oscillator(kStop);
  const State state = initial_state(scene, assemble(scene));
  EXPECT_EQ(state.q, Vector::Zero(2));
  EXPECT_EQ(state.qdot, Vector::Zero(2));
  const Scene moving = oscillator(kStop, "[initial]\nq = [0.05, 0.0]\nqdot = [1.0, -1.0]\n");
  EXPECT_EQ(initial_state(moving, assemble(moving)).qdot[1], -1.0);
}

TEST(System, StartBeyondTheStopIsAnErrorWithItsPlaceAndDepth) {
  // 0.3 - 2 (-0.1) = 0.5: .4 beyond the gap.
  const std::string message =
      start_error(oscillator(kStop, "[initial]\nq = [0.3, -0.1]\nqdot = [0.0, 0.0]\n"));
  EXPECT_EQ(message.find("oscillator.toml:16:"), 0u) << message;
  EXPECT_NE(message.find("initial.q"), std::string::npos) << message;
  EXPECT_NE(message.find("0.4 m"), std::string::npos) << message;
  EXPECT_NE(message.find("stop 1"), std::string::npos) << message;
}

TEST(System, StartOnTheStopIsAllowedWithinRounding) {
  EXPECT_EQ(start_error(oscillator(kStop, "[initial]\nq = [0.1, 0.0]\nqdot = [0.0, 0.0]\n")),
            "accepted");
  // .3 - .1 - .1 is .1 but for rounding.
  EXPECT_EQ(start_error(oscillator(kStop, "[initial]\nq = [0.3, 0.1]\nqdot = [0.0, 0.0]\n")),
            "accepted");
  EXPECT_NE(
      start_error(oscillator(kStop, "[initial]\nq = [0.1000000000001, 0.0]\nqdot = [0.0, 0.0]\n")),
      "accepted");
}

TEST(System, PreloadedStopStartsInStaticEquilibrium) {
  // One mode: x'' + w^2 x pressed to x = -a needs no more than q = a/b.
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [1.5, 4.0]\n[[stop]]\nshape = [1.0, -2.0]\ngap = -0.1\n"
      "restitution = 0.7\n",
      "pressed.toml");
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  // q_j proportional to d_j/w_j^2, b.q = a.
  const double soft = 1.0 / 2.25, stiff = -2.0 / 16.0;
  const double force = -0.1 / (soft - 2.0 * stiff);
  EXPECT_NEAR(start.q[0], force * soft, 1e-16);
  EXPECT_NEAR(start.q[1], force * stiff, 1e-16);
  EXPECT_EQ(start.qdot.norm(), 0.0);
}

// Its weight holds it clear of the preloaded stop: q = -9.81/4, nothing pressed.
TEST(System, PreloadedStopThatTheLoadKeepsClearIsNotTouchedAtTheStart) {
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [2.0]\ninertia = [1.0]\n[gravity]\nacceleration = -9.81\n"
      "[[stop]]\nshape = [1.0]\ngap = -1.0\nrestitution = 0.5\n",
      "hanging");
  EXPECT_NEAR(initial_state(scene, assemble(scene)).q[0], -9.81 / 4.0, 1e-15);
}

// Two preloaded stops at nearly the same place: their forces are large and nearly cancel, and yet
// the structure starts on both to the rounding of the gap.
TEST(System, PreloadOnTwoStopsStartsOnBoth) {
  for (int i = 1; i <= 200; ++i) {
    const double shape = -0.7573359957408217 - 0.003 * i, gap = -0.49462350597752763 - 0.001 * i;
    const Scene scene = parse_scene(
        "[modal]\nfrequencies = [700.0, 496.8302297571207]\n"
        "[[stop]]\nshape = [0.014, 0.66]\ngap = 0.048\nrestitution = 0.72\n"
        "[[stop]]\nshape = [0.4365084619759272, " +
            fmt::format("{}", shape) + "]\ngap = " + fmt::format("{}", gap) +
            "\nrestitution = 0.0\n",
        "pair.toml");
    const System system = assemble(scene);
    const State start = initial_state(scene, system);
    for (const Stop& stop : system.stops) {
      const GapValue<double> value = gap_value<double>(stop.row, start.q, stop.gap);
      EXPECT_LE(std::abs(value.value), value.rounding) << i;
    }
  }
}

TEST(System, PreloadBesideAStopThatHasNoForce) {
  // The second stop is out of reach: it must not pull.
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [1.0, 2.0]\n[[stop]]\nshape = [1.0, 1.0]\ngap = -0.2\n"
      "restitution = 0.7\n[[stop]]\nshape = [1.0, -1.0]\ngap = 0.5\nrestitution = 0.7\n",
      "pressed.toml");
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  EXPECT_NEAR(start.q[0], -0.16, 1e-16);
  EXPECT_NEAR(start.q[1], -0.04, 1e-16);
}

TEST(System, PreloadWithoutStiffnessOrWithoutRoomIsAnError) {
  const auto message = [](const std::string& text) {
    const Scene scene = parse_scene(text, "pressed.toml");
    return start_error(scene);
  };
  const std::string free_mass = message(
      "[modal]\nfrequencies = [0.0]\n[[stop]]\nshape = [1.0]\ngap = -0.1\nrestitution = 0.7\n");
  EXPECT_EQ(free_mass.find("pressed.toml:5:"), 0u) << free_mass;
  EXPECT_NE(free_mass.find("static equilibrium"), std::string::npos) << free_mass;
  const std::string no_room = message(
      "[modal]\nfrequencies = [1.0]\n[[stop]]\nshape = [1.0]\ngap = -0.2\nrestitution = 0.7\n"
      "[[stop]]\nshape = [1.0]\ngap = 0.1\nside = \"below\"\nrestitution = 0.7\n");
  EXPECT_NE(no_room, "accepted");
}

Scene beam(int modes, const std::string& points, const std::string& impulse = "momentum",
           const std::string& discretisation = "collocation") {
  return parse_scene(
      "[beam]\nlength = 1.0\nyoungs_modulus = 1.0\nsecond_moment = 1.0\n"
      "density = 1.0\narea = 1.0\nmodes = " +
          std::to_string(modes) + "\ndiscretisation = \"" + discretisation + "\"\n" + points +
          "[forcing]\nkind = \"base\"\namplitude = 1.0\nfrequency = 1.0\n"
          "[[stop]]\nposition = 1.0\ngap = 1.0\nrestitution = 0.8\nimpulse = \"" +
          impulse + "\"\n",
      "beam.toml");
}

std::string uniform_on(double from, int modes) {
  std::string text = "points = [";
  for (int i = 0; i < modes; ++i)
    text += std::to_string(from + (1.0 - from) * i / (modes - 1)) + (i + 1 < modes ? ", " : "]\n");
  return text;
}

TEST(System, EvenPointsAreWellConditioned) {
  // The catalogue of hard cases: 2.07 up to N = 40.
  for (const int modes : {4, 8, 16, 40})
    EXPECT_NEAR(collocation_condition(modal_model(beam(modes, ""))), 2.07, 0.02) << modes;
  EXPECT_TRUE(system_warnings(beam(40, ""), assemble(beam(40, ""))).empty());
}

TEST(System, PointsOnTheOuterHalfAreNot) {
  EXPECT_NEAR(collocation_condition(modal_model(beam(4, uniform_on(0.5, 4)))), 11.7, 0.05);
  EXPECT_NEAR(collocation_condition(modal_model(beam(10, uniform_on(0.5, 10)))) / 2.5e6, 1.0, 0.02);
}

TEST(System, IllConditionedPointsAreWarnedOf) {
  const Scene scene = beam(14, uniform_on(0.5, 14));
  EXPECT_GT(collocation_condition(modal_model(scene)), 1e8);
  const auto warnings = system_warnings(scene, assemble(scene));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("condition"), std::string::npos);
  // Below 1e8 there is nothing to say.
  EXPECT_TRUE(
      system_warnings(beam(10, uniform_on(0.5, 10)), assemble(beam(10, uniform_on(0.5, 10))))
          .empty());
}

TEST(System, ObliqueImpulseIsWarnedOfWithItsWorstGain) {
  const Scene scene = support::shipped_scene("01_wagg_2004", {"beam.modes=2"});
  const auto warnings = system_warnings(scene, assemble(scene));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("1.66436"), std::string::npos) << warnings[0];
  const Scene one = support::shipped_scene("01_wagg_2004", {"beam.modes=1"});
  EXPECT_TRUE(system_warnings(one, assemble(one)).empty());
  const Scene momentum = support::shipped_scene("02_wagg_momentum");
  EXPECT_TRUE(system_warnings(momentum, assemble(momentum)).empty());
}

TEST(System, GalerkinForcingMayGoWithTheCollocationLaw) {
  const Scene scene = beam(3, "", "collocation", "galerkin");
  EXPECT_NEAR(collocation_condition(modal_model(scene)), 2.07, 0.1);
  const System system = assemble(scene);
  EXPECT_NEAR(system.stops[0].row.dot(system.stops[0].direction()), 1.0, 1e-14);
  EXPECT_GT((system.stops[0].direction() - system.stops[0].row / 12.0).norm(), 1e-3);
}

}  // namespace
}  // namespace graze
