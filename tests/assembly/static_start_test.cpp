// Preloaded compliant stops (negative gap) start in static equilibrium. Expected: closed forms, and
// equilibria made backwards, from the depths to the gaps that have them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// Two modes whose static compliances are 1/2.25 and 1/16.
System structure() {
  Vector omega(2);
  omega << 1.5, 4.0;
  return {omega, NaturalModes{Vector::Zero(2)}, {}};
}

void add_spring(System& system, double first, double second, double k, double exponent) {
  Vector row(2);
  row << first, second;
  ContactForce law;
  law.stiffness = k;
  law.exponent = exponent;
  system.stops.push_back({row, 0.0, law});
}

State start_of(const System& system) { return initial_state({}, system); }

double depth_at(const System& system, std::size_t stop, const Vector& q) {
  return system.stops[stop].row.dot(q) - system.stops[stop].gap;
}

// F = k e/(1 + G k), e the depth without the force and G the compliance of the structure there.
TEST(StaticStart, LinearSpring) {
  for (const double k : {1e-3, 1.0, 1e4, 1e10}) {
    System system = structure();
    add_spring(system, 1.0, -2.0, k, 1.0);
    system.stops[0].gap = -0.1;
    const double compliance = 1.0 / 2.25 + 4.0 / 16.0, force = 0.1 * k / (1.0 + compliance * k);
    const State start = start_of(system);
    EXPECT_NEAR(start.q[0] / (-force / 2.25), 1.0, 1e-15);
    EXPECT_NEAR(start.q[1] / (2.0 * force / 16.0), 1.0, 1e-15);
    EXPECT_EQ(start.qdot.norm(), 0.0);
  }
}

// x + G k x^2 = e: x = 2 e/(1 + sqrt(1 + 4 G k e)).
TEST(StaticStart, QuadraticSpring) {
  for (const double k : {1e-2, 1.0, 1e6, 1e12}) {
    System system = structure();
    add_spring(system, 1.0, -2.0, k, 2.0);
    system.stops[0].gap = -0.1;
    const double compliance = 1.0 / 2.25 + 4.0 / 16.0;
    const double x = 0.2 / (1.0 + std::sqrt(1.0 + 0.4 * compliance * k));
    EXPECT_NEAR(start_of(system).q[0] / (-k * x * x / 2.25), 1.0, 3e-15) << k;
  }
}

// A gap made for a depth of a Hertz spring of any stiffness.
TEST(StaticStart, HertzSpring) {
  for (const double k : {1.0, 1e5, 1e10})
    for (const double x : {1e-7, 1e-3, 0.1}) {
      System system = structure();
      add_spring(system, 1.0, -2.0, k, 1.5);
      const double force = k * std::pow(x, 1.5);
      system.stops[0].gap = -(x + (1.0 / 2.25 + 4.0 / 16.0) * force);
      // What of e is rounding changes the force by as much at most.
      EXPECT_NEAR(start_of(system).q[1] / (2.0 * force / 16.0), 1.0,
                  1e-14 * (1.0 - system.stops[0].gap / x))
          << k << " " << x;
    }
}

// Springs at three places, one of them clear, beside a rigid stop that is pressed with 0.3 N.
TEST(StaticStart, SeveralStopsTogether) {
  for (const double stiff : {1.0, 1e3, 1e7}) {
    SCOPED_TRACE(stiff);
    System system = structure();
    add_spring(system, 1.0, 0.5, 2.0 * stiff, 1.5);
    add_spring(system, 0.3, -1.0, stiff, 1.0);
    add_spring(system, -0.7, 0.1, 3.0 * stiff, 1.5);
    add_spring(system, 0.9, 0.6, 0.0, 1.0);
    system.stops[3].law = ImpactLaw{system.stops[3].row};
    const std::vector<double> force = {stiff * 2e-3, stiff * 4e-3, 0.0, 0.3};
    system.modal().load = Vector(2);
    *system.modal().load << 0.2, -0.1;
    Vector q = *system.load();
    for (std::size_t i = 0; i < 4; ++i) q -= force[i] * system.stops[i].row;
    q[0] /= 2.25;
    q[1] /= 16.0;
    const std::vector<double> depth = {std::pow(1e-3, 2.0 / 3.0), 4e-3, -0.5, 0.0};
    for (std::size_t i = 0; i < 4; ++i) system.stops[i].gap = system.stops[i].row.dot(q) - depth[i];
    const State start = start_of(system);
    EXPECT_NEAR(start.q[0] / q[0], 1.0, 1e-12);
    EXPECT_NEAR(start.q[1] / q[1], 1.0, 1e-12);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(depth_at(system, i, start.q), depth[i], 1e-13 * q.norm()) << i;
  }
}

// Its load holds it clear of the spring.
TEST(StaticStart, ClearOfThePreloadedSpring) {
  System system = structure();
  add_spring(system, 1.0, 0.0, 1e6, 1.5);
  system.stops[0].gap = -1.0;
  system.modal().load = Vector(2);
  *system.modal().load << -9.0, 0.0;
  EXPECT_EQ(start_of(system).q[0], -4.0);
}

Scene preloaded_beam(const std::string& spring) {
  return parse_scene(
      "[beam]\nlength = 0.3\nyoungs_modulus = 205e9\nsecond_moment = 24.4e-14\n"
      "density = 8500.0\narea = 12.4e-6\nmodes = 4\n[damping]\nviscous = 0.005\n"
      "[[stop]]\nposition = 0.3\ngap = -1e-4\nside = \"below\"\n[stop.spring]\n" +
          spring,
      "pressed.toml");
}

// Nothing moves without forcing, for some 200 periods of the slowest mode on the spring.
TEST(StaticStart, StaysAtRest) {
  for (const char* spring :
       {"stiffness = 1e7\nexponent = 1\n", "stiffness = 1e9\nexponent = 1.5\n",
        "stiffness = 1e3\nexponent = 1\n"
        "damping = { model = \"kelvin-voigt\", mass = 0.002, ratio = 0.2 }\n",
        "stiffness = 1e9\nexponent = 1.5\n"
        "damping = { model = \"hunt-crossley\", restitution = 0.5, speed = 0.1 }\n"}) {
    SCOPED_TRACE(spring);
    const Scene scene = preloaded_beam(spring);
    const System system = assemble(scene);
    const State start = initial_state(scene, system);
    EXPECT_GT(depth_at(system, 0, start.q), 0.0);
    SimulationOptions options;
    options.duration = 10.0;
    int events = 0;
    RunListeners listeners;
    listeners.event = [&events](const Event&) { ++events; };
    const Simulation run = simulate(system, start, options, listeners);
    EXPECT_EQ(run.outcome, RunOutcome::kReachedEnd) << run.message;
    EXPECT_EQ(events, 0);
    EXPECT_LT((run.final.q - start.q).norm(), 1e-9 * start.q.norm());
    EXPECT_LT(run.final.qdot.norm(), 1e-9 * start.q.norm() * system.omega[0]);
  }
}

// A free body between two preloaded springs: k1 (g1 + x) = k2 (g2 - x); of Hertz's law with equal
// stiffnesses g1 + x = g2 - x.
TEST(StaticStart, OfAFreeBodyClaspedByTwoSprings) {
  const auto start_of = [](double k1, double g1, double k2, double g2, double exponent) {
    const Scene scene = parse_scene(
        fmt::format("[modal]\nfrequencies = [0.0]\n[[stop]]\nshape = [1.0]\ngap = {}\n"
                    "[stop.spring]\nstiffness = {}\nexponent = {}\n[[stop]]\nshape = [1.0]\n"
                    "gap = {}\nside = \"below\"\n[stop.spring]\nstiffness = {}\nexponent = {}\n",
                    -g1, k1, exponent, -g2, k2, exponent),
        "clasped.toml");
    return initial_state(scene, assemble(scene)).q[0];
  };
  EXPECT_EQ(start_of(1000.0, 0.01, 1000.0, 0.01, 1.0), 0.0);
  EXPECT_NEAR(start_of(1000.0, 0.02, 3000.0, 0.01, 1.0), 10.0 / 4000.0, 2e-16);
  EXPECT_NEAR(start_of(1000.0, 0.0, 3000.0, 0.01, 1.0), 30.0 / 4000.0, 2e-16);
  EXPECT_NEAR(start_of(1e6, 0.03, 1e6, 0.01, 1.5), -0.01, 2e-16);
}

TEST(StaticStart, OfAFreeBodyThereIsNone) {
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [0.0]\n[[stop]]\nshape = [1.0]\ngap = -0.1\n"
      "[stop.spring]\nstiffness = 1e4\nexponent = 1.5\n",
      "pressed.toml");
  try {
    initial_state(scene, assemble(scene));
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find("pressed.toml:5:"), 0u) << message;
    EXPECT_NE(message.find("static equilibrium"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace graze
